"""The reference of the library: a page per public header, from its `///` comments.

The headers are regular: a comment of `///` lines stands before what it describes, `///<` behind it, members are indented by two, and
private members end a class. So a reader of lines is enough; what it does not understand it shows as it stands.
"""
import dataclasses
import pathlib
import re


@dataclasses.dataclass
class Entity:
    """A declaration with its comment; `members` of a class. `code` is the declaration as it stands."""
    comment: list
    code: list
    members: list = dataclasses.field(default_factory=list)

    @property
    def name(self):
        text = " ".join(line.strip() for line in self.code)
        text = re.sub(r"\[\[\w+(\(.*?\))?\]\]|//.*", "", text)
        text = re.sub(r"^template <.*?>+ (requires \S+ )?", "", text.strip())
        if found := re.match(r"(?:class|struct|enum class|enum|union)\s+([\w:]+)", text):
            return found[1]
        if found := re.match(r"using\s+(\w+)", text):
            return found[1]
        if "operator" not in text:
            text = re.sub(r"\s*(=|\{).*", ";", text)  # without the value or the body
        if found := re.search(r"(operator\s*(?:\(\)|\[\]|[^\s(]+)|~?[\w:]+)\s*\(", text):
            return found[1]
        found = re.search(r"([\w:]+)\s*(?:\{.*\}|=.*)?;", text)
        return found[1] if found else text[:40]

    @property
    def is_class(self):
        return re.match(r"(template .*)?(class|struct)\s+\w+[^;]*$", self.code[0].strip()) is not None


def declaration(lines, begin):
    """The end of the declaration that begins at a line: where brackets are closed and a `;` or `}` ends it."""
    depth = 0
    for k in range(begin, len(lines)):
        text = re.sub(r'//.*|"(\\.|[^"])*"|\'(\\.|[^\'])\'', "", lines[k])
        depth += sum(text.count(c) for c in "({") - sum(text.count(c) for c in ")}")
        if depth <= 0 and re.search(r"[;}]\s*$", text):
            return k + 1
        if depth <= 0 and not text.strip():
            return k + 1
    return len(lines)


def entities(lines, indent=""):
    """The declarations at one level. Text without a comment joins the entity before it, if that has no gap behind it."""
    found = []
    comment = []
    k = 0
    while k < len(lines):
        line = lines[k]
        text = line.strip()
        if text == "private:":
            break
        if text.startswith("///") and not text.startswith("///<"):
            comment.append(text[3:].removeprefix(" "))
            k += 1
            continue
        if not text or text.startswith(("#", "namespace ", "}", "public:", "//")):
            if not text and comment and not found and indent == "":
                comment = []  # of the file
            k += 1
            continue
        end = declaration(lines, k)
        code = [each.removeprefix(indent) for each in lines[k:end]]
        joins = found and not comment and k > 0 and lines[k - 1].strip() and not lines[k - 1].strip().startswith("//")
        if joins and not found[-1].is_class:
            found[-1].code += code
        else:
            entity = Entity(comment, code)
            if entity.is_class and "{" in "".join(code):
                opening = next(i for i, each in enumerate(code) if "{" in each)
                if opening < len(code) - 1:
                    entity.members = entities(lines[k + opening + 1:end - 1], indent + "  ")
                    entity.code = [each for each in code[:opening + 1]]
            found.append(entity)
        comment = []
        k = end
    return found


def prose(comment):
    """Lines of a comment as Markdown: indented lines are code, laws and sources begin lines of their own."""
    out = []
    code = False
    for line in comment:
        indented = line.startswith("  ") and (code or not out or out[-1] == "" or line.startswith("   "))
        if indented != code:
            out.append("```cpp" if indented else "```")
            if not indented:
                out.append("")
            code = indented
        out.append(line.removeprefix("  ") if indented else line.replace("<", "&lt;"))
    if code:
        out.append("```")
    text = "\n".join(out)
    return re.sub(r"(?<!^)(?<!\n\n)\b(Laws?|Throws|Source|Exact|Degenerate): ", r"\n\n**\1:** ", text)


def render(entity, level):
    mark = "#" * level
    is_data = level > 2 and not entity.comment and "(" not in entity.code[0]
    out = [] if is_data else [f"{mark} {entity.name.replace('<', '&lt;')}", ""]
    if entity.comment:
        out += [prose(entity.comment), ""]
    shown = list(entity.code)
    if entity.members:
        shown[-1] = re.sub(r"\s*\{\s*(//.*)?$", ";", shown[-1])
    out += ["```cpp", *shown, "```", ""]
    for member in entity.members:
        out += render(member, level + 1)
    return out


def page(header):
    """The page of a header: its own comment, then its entities."""
    lines = pathlib.Path(header).read_text(encoding="utf-8").splitlines()
    about = []
    for line in lines[1:]:
        if not line.startswith("///"):
            break
        about.append(line[3:].removeprefix(" "))
    name = pathlib.Path(header).name
    out = [f"# {name}", "", prose(about), "", f"`#include <strata/{name}>`", ""]
    body = lines[1 + len(about):]
    for entity in entities(body):
        out += render(entity, 2)
    return "\n".join(out) + "\n"


def summary(header):
    """The first sentence of a header's comment."""
    lines = pathlib.Path(header).read_text(encoding="utf-8").splitlines()
    about = " ".join(line[3:].strip() for line in lines[1:] if line.startswith("///"))
    return re.split(r"(?<=[.:]) ", about)[0].rstrip(":") if about else ""
