# The site of the documentation (`make docs`), by Sphinx from the pages as they are: README.md and docs/*.md are also read
# on forges and in the workbench's help. docs/README.md lists the pages; the navigation is made from that list.

import json
import os
import re
import shutil
import subprocess
from pathlib import Path

from docutils.nodes import SkipNode
from pygments.lexers.special import TextLexer

root = Path(__file__).parents[2]
katex = root / "web/node_modules/katex"

project = "Talus"
author = "The Talus authors"
copyright = "2026 the Talus authors"
version = release = re.search(r"project\(talus VERSION (\S+)", (root / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser"]
root_doc = "README"
pages_beside_docs = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", "EXTENDING.md", "CHANGELOG.md"]
include_patterns = ["docs/**.md", *pages_beside_docs]
# Without these Sphinx would walk through builds and node_modules.
exclude_patterns = [name for name in os.listdir(root) if name not in ["docs", *pages_beside_docs]]

myst_heading_anchors = 6  # as forges form them
suppress_warnings = ["misc.highlighting_failure"]  # JSON that leaves parts out
highlight_language = "none"

html_theme = "furo"
html_title = f"Talus {version}"
html_favicon = "../../web/public/icon.svg"
html_static_path = ["site.css"]
html_css_files = ["katex.css", "site.css"]
html_copy_source = False
html_theme_options = {"sidebar_hide_name": False}
html_math_renderer = "katex"


def navigation():
    """The contents as docs/README.md has them: for each of its sections the pages that the list links."""
    text = (root / "docs/README.md").read_text()
    contents = "\n```{toctree}\n:hidden:\n\nAll pages <docs/README>\n```\n"
    for section in re.split(r"^## ", text, flags=re.M)[1:]:
        caption, _, body = section.partition("\n")
        items = "\n".join(re.findall(r"^- .*(?:\n  .*)*", body, flags=re.M))
        entries = []
        for title, path in re.findall(r"\[([^\]]+)\]\(([^)#]+\.md)\)", items):
            page = os.path.normpath(f"docs/{path}").removesuffix(".md")
            entry = f"{title[0].upper()}{title[1:]} <{page}>"
            if f"<{page}>" not in contents + str(entries):
                entries.append(entry)
        contents += "\n".join(["", "```{toctree}", ":hidden:", f":caption: {caption}", "", *entries, "```", ""])
    return contents


def as_myst(app, docname, source):
    """Equations as forges write them become those of MyST."""
    text = re.sub(r"^```math$", "```{math}", source[0], flags=re.M)
    source[0] = re.sub(r"\$`([^`]+)`\$", r"{math}`\1`", text)
    if docname == root_doc:
        source[0] += navigation()


class Katex:
    """Sets equations while the site is built, so that its pages need neither scripts nor a network for them."""

    process = None

    def html(self, equation, is_block):
        if self.process is None:
            self.process = subprocess.Popen(["node", Path(__file__).parent / "katex.mjs"], text=True,
                                            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.process.stdin.write(json.dumps({"equation": equation, "isBlock": is_block}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "problem" in answer:
            raise ValueError(f"{answer['problem']}: {equation}")
        return answer["html"]


setter = Katex()


def inline_equation(translator, node):
    translator.body.append(setter.html(node.astext(), False))
    raise SkipNode


def block_equation(translator, node):
    translator.body.append(f'<div class="equation">{setter.html(node.astext(), True)}</div>')
    raise SkipNode


def without_theme_script(app, page, template, context, doctree):
    """Debian's Furo has a script in parts, which browsers cannot load from files; all works without it."""
    context["script_files"] = [script for script in context.get("script_files", []) if "furo.js" not in script]


def mend_theme(static):
    """Debian's Furo takes a style sheet from a server, and its dark colours from a button that needs the script."""
    styles = static / "styles/furo.css"
    text = styles.read_text()
    text = text.replace("url(/javascript/normalize.css/normalize.css)", "url(../normalize.css)")
    dark = re.search(r'body\[data-theme="dark"\] \{(.*?)\}', text, flags=re.S)[1]
    styles.write_text(f"{text}\n@media (prefers-color-scheme: dark) {{\n  body {{{dark}}}\n}}\n")
    shutil.copy("/usr/share/javascript/normalize.css/normalize.css", static)


def finish(app, problem):
    if problem is not None:
        return
    out = Path(app.outdir)
    mend_theme(out / "_static")
    css = (katex / "dist/katex.min.css").read_text()  # names each font in three formats; browsers take the first
    (out / "_static/katex.css").write_text(re.sub(r',url\([^)]*\.(woff|ttf)\) format\("\w+"\)', "", css))
    fonts = out / "_static/fonts"
    fonts.mkdir(exist_ok=True)
    for font in (katex / "dist/fonts").glob("*.woff2"):
        shutil.copy(font, fonts)
    shutil.copy(katex / "LICENSE", out / "_static/katex-licence.txt")
    (out / "index.html").write_text('<!doctype html><meta charset="utf-8"><title>Talus</title>'
                                    '<meta http-equiv="refresh" content="0; url=README.html">'
                                    '<a href="README.html">Talus</a>\n')


def setup(app):
    app.add_lexer("csv", TextLexer)
    app.add_html_math_renderer("katex", (inline_equation, None), (block_equation, None))
    app.connect("source-read", as_myst)
    app.connect("html-page-context", without_theme_script, priority=900)
    app.connect("build-finished", finish)
