"""The reference of the command line: a page per verb, from `strata describe`, and one per schema, from `strata schema`."""
import json
import re
import subprocess


def run(tool, *arguments):
    return subprocess.run([tool, *arguments], check=True, capture_output=True, text=True).stdout


def escaped(text):
    return str(text).replace("|", "\\|").replace("<", "&lt;").replace("\n", " ")


def usage(verb, name):
    words = [name]
    for operand in verb["operands"]:
        word = " ".join([operand["name"]] * max(1, operand["least"]))
        if operand["most"] is None or operand["most"] > max(1, operand["least"]):
            word += "..."
        words.append(word if operand["least"] else f"[{word}]")
    words += [f"{option['names'][0]} {option['value']}" for option in verb["options"] if option["required"]]
    if verb["verbs"]:
        words.append("VERB")
    return " ".join([*words, "[OPTIONS]"])


def option_row(option):
    names = ", ".join(f"`{name}`" for name in option["names"])
    value = "" if option["flag"] else f" `{escaped(option['value'])}`"
    about = escaped(option["about"])
    if option["choices"]:
        about += "; one of " + ", ".join(f"`{word}`" for word in option["choices"])
    if option["default"] is not None:
        about += f"; unless given: `{escaped(option['default'])}`"
    return f"| {names}{value} | {about}{' (required)' if option['required'] else ''} |"


def verb_text(verb, name, level, schemas):
    mark = "#" * level
    out = [f"{mark} {name}", "", verb["about"] + ".", "", "```text", usage(verb, name), "```", ""]
    if verb["aliases"]:
        out += ["Also named " + ", ".join(f"`{alias}`" for alias in verb["aliases"]) + ".", ""]
    if verb["more"]:
        out += [re.sub(r"(?m)^(  .*)$", r"    \1", verb["more"].replace("<", "&lt;")), ""]
    if verb["examples"]:
        out += [f"{mark}# Examples" if level == 1 else "Examples:", "", "```sh", *verb["examples"], "```", ""]
    if verb["operands"] or verb["options"]:
        out += ["| operands and options | |", "|---|---|"]
        out += [f"| `{operand['name']}` | {escaped(operand['about'])} |" for operand in verb["operands"]]
        out += [option_row(option) for option in verb["options"] if "--help" not in option["names"]] + [""]
    path = name.removeprefix("strata ").strip()
    if path in schemas:
        out += [f"Its report: [schema](../schemas/{path.replace(' ', '-')}.md).", ""]
    for inner in verb["verbs"]:
        out += verb_text(inner, f"{name} {inner['name']}", level + 1, schemas)
    return out


def pages(tool):
    """(path within reference/verbs, text) of every verb, and of the list of all."""
    program = json.loads(run(tool, "describe"))
    schemas = run(tool, "schema").split("\n")
    index = ["# Verbs", "", "What `strata --help` and `strata VERB --help` say, from the program itself.", "", "| verb | |", "|---|---|"]
    for verb in program["verbs"]:
        yield f"{verb['name']}.md", "\n".join(verb_text(verb, f"strata {verb['name']}", 1, schemas)) + "\n"
        index.append(f"| [{verb['name']}]({verb['name']}.md) | {escaped(verb['about'])} |")
    yield "index.md", "\n".join(index) + "\n"


def kind(schema):
    if "$ref" in schema:
        name = schema["$ref"].split("/")[-1]
        return f"[{name}](#{name})"
    if "anyOf" in schema:
        return " or ".join(kind(each) for each in schema["anyOf"])
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    if "enum" in schema:
        return " or ".join(f"`{json.dumps(each)}`" for each in schema["enum"])
    name = schema.get("type", "any")
    name = " or ".join(name) if isinstance(name, list) else name
    return f"array of {kind(schema['items'])}" if name == "array" and isinstance(schema.get("items"), dict) else name


def members(schema, out):
    if "properties" not in schema:
        out += [f"{kind(schema)}. {schema.get('description', '')}", ""]
        return
    out += ["| member | type | |", "|---|---|---|"]
    for name, part in schema["properties"].items():
        there = "" if name in schema.get("required", ()) else " (not always there)"
        out.append(f"| `{name}` | {kind(part)} | {escaped(part.get('description', ''))}{there} |")
    out.append("")


def schema_pages(tool):
    """(path within reference/schemas, text) of every verb with a schema; the schema itself as a file beside."""
    verbs = run(tool, "schema").split("\n")
    index = ["# Report schemas", "", "JSON Schema, draft 2020-12. `strata schema VERB` prints them. Readers must ignore members that they do not know.",
             "", "| verb | page | schema |", "|---|---|---|"]
    for verb in filter(None, verbs):
        name = verb.replace(" ", "-")
        text = run(tool, "schema", *verb.split())
        schema = json.loads(text)
        out = [f"# The report of {verb}", "", schema.get("description", ""), "", f"[{name}.schema.json]({name}.schema.json), or `strata schema {verb}`", ""]
        members(schema, out)
        for part, definition in schema.get("$defs", {}).items():
            out += [f"## {part}", ""]
            if "properties" in definition:
                out += [definition.get("description", ""), ""]
            members(definition, out)
        yield f"{name}.md", "\n".join(out)
        yield f"{name}.schema.json", text
        index.append(f"| {verb} | [members]({name}.md) | [{name}.schema.json]({name}.schema.json) |")
    yield "index.md", "\n".join(index) + "\n"
