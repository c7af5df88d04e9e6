"""Which files a change touches, for tools/lint and tools/sanitize."""
import pathlib
import subprocess

root = pathlib.Path(__file__).resolve().parent.parent


def git(*arguments):
    """What git prints, or None where it fails."""
    done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else None


def base_of_change(revision=None):
    """The commit that this branch left `revision` at; without one, origin/main or main. On that branch itself, or where there
    is none, the commit before. None where there is nothing to compare with."""
    for candidate in [revision] if revision else ["origin/main", "main"]:
        base = git("merge-base", "HEAD", candidate)
        if base and base != git("rev-parse", "HEAD"):
            return base
    return git("rev-parse", "--verify", "--quiet", "HEAD~1")


def changed_files(base, *patterns):
    """Files that differ from a commit and are still there."""
    listed = git("diff", "--name-only", "--diff-filter=d", base, "--", *patterns)
    return (listed or "").splitlines()
