package badlog.site

/** The frame of each guide: the search, the contents of the site, and the contents of the page. */
internal class Frame(private val contents: Contents) {
    /** Returns the whole page of [guide]. */
    fun page(guide: Guide): String {
        val here = guide.address
        val title = if (here == "index.html") "badlog: why did the robot do that?" else "${guide.title} · badlog"
        return """
            |<!doctype html>
            |<html lang="en">
            |<head>
            |<meta charset="utf-8">
            |<meta name="viewport" content="width=device-width, initial-scale=1">
            |<meta name="color-scheme" content="light dark">
            |<title>${escape(title)}</title>
            |<meta name="description" content="${escape(guide.summary.replace('\n', ' ').take(SUMMARY))}">
            |<link rel="stylesheet" href="${link(here, "site.css")}">
            |<script src="${link(here, "site.js")}"></script>
            |</head>
            |<body data-root="${link(here, "index.html").removeSuffix("index.html")}">
            |<a class="skip" href="#content">Skip to the text</a>
            |<header>
            |<a class="menu" href="#contents">Menu</a>
            |<a class="brand" href="${link(here, "index.html")}">badlog</a>
            |<form class="search" role="search">
            |<input type="search" placeholder="Search" aria-label="Search all guides" aria-keyshortcuts="/" autocomplete="off" spellcheck="false">
            |<div class="results" role="region" aria-live="polite" aria-label="Search results" hidden></div>
            |</form>
            |<button class="theme" type="button" aria-label="Switch between light and dark" hidden></button>
            |</header>
            |<div class="columns">
            |<main id="content">
            |${guide.html.trim()}
            |</main>
            |${outline(guide)}
            |<nav id="contents" class="contents" aria-label="All guides">
            |${contents.sections.joinToString("\n") { section(it, here) }}
            |</nav>
            |</div>
            |</body>
            |</html>
            |
        """.trimMargin()
    }

    private fun section(section: Contents.Section, here: String): String {
        val entries = section.entries.joinToString("\n") { entry ->
            val current = if (entry.address == here) " aria-current=\"page\"" else ""
            "<li><a href=\"${escape(link(here, entry.address))}\"$current>${escape(entry.title)}</a></li>"
        }
        return "<h2>${escape(section.title)}</h2>\n<ul>\n$entries\n</ul>"
    }

    /** Returns the headings of the page, if there are enough for an outline. */
    private fun outline(guide: Guide): String {
        val headings = guide.sections.filter { it.level == 2 }
        if (headings.size < 3) return ""
        val links = headings.joinToString("\n") { "<li><a href=\"#${it.anchor}\">${escape(it.heading)}</a></li>" }
        return "<nav class=\"outline\" aria-label=\"On this page\">\n<h2>On this page</h2>\n<ul>\n$links\n</ul>\n</nav>"
    }

    private fun link(from: String, to: String): String = relativeAddress(from, to)
}

/** Returns [text] escaped for HTML, also inside quotes. */
internal fun escape(text: String): String = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")

/** The maximum length of a description that search engines show. */
private const val SUMMARY = 160
