"""What MkDocs cannot know of the pages' links: those to files of the source tree, which are no part of
the site, become the file's name; those to a heading must name one. Called by MkDocs (mkdocs.yml)."""
import re
from pathlib import Path

from mkdocs.exceptions import PluginError

ROOT = Path(__file__).resolve().parent.parent
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\(([^)#\s]*)(#[^)\s]*)?\)")


def anchors(text):
    """Headings of a page as the links to them have them."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), re.MULTILINE)
    return {re.sub(r"[\s]+", "-", re.sub(r"[^\w\s-]", "", one).strip().lower()) for one in headings}


def on_page_markdown(markdown, page, **_):
    folder = ROOT / "docs" / Path(page.file.src_path).parent

    def resolved(match):
        text, target, anchor = match[1], match[2], match[3] or ""
        if "://" in target or target.startswith("mailto:"):
            return match[0]
        file = (folder / target).resolve() if target else ROOT / "docs" / page.file.src_path
        if not file.exists():
            raise PluginError(f"{page.file.src_path}: {target} does not exist")
        if anchor and file.suffix == ".md" and anchor[1:] not in anchors(file.read_text()):
            raise PluginError(f"{page.file.src_path}: {file.name} has no heading {anchor}")
        return match[0] if ROOT / "docs" in file.parents else f"`{file.relative_to(ROOT)}`"

    return LINK.sub(resolved, markdown)
