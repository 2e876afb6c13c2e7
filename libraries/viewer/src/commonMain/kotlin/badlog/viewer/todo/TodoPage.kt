package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.viewer.text.word

/**
 * Returns the list and the [checklist] before the next match as a page. It is one file of HTML without scripts, for a browser or for
 * paper, light or dark as the reader's system is.
 *
 * @param place the owner of the list, such as the name of a folder.
 */
fun TodoList.toPage(place: String, checklist: List<String> = emptyList()): String = buildString {
    val title = "To do: $place"
    append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
    append("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n")
    append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n")
    append("$GENERATOR\n")
    append("<title>${html(title)}</title>\n<style>$STYLE</style>\n</head>\n<body>\n<h1>${html(title)}</h1>\n")
    if (open.isEmpty()) append("<p>Nothing is open.</p>\n") else appendItems(open)
    val lines = checklist(checklist)
    if (lines.isNotEmpty()) {
        append("<h2>${html(checklistTitle(next))}</h2>\n<ul>\n")
        for (line in lines) {
            val by = line.done?.let { " <span>${html(it.by)}</span>" }.orEmpty()
            append("<li>${box(line.done != null)}<div>${html(line.check.text)}$by</div></li>\n")
        }
        append("</ul>\n")
    }
    if (done.isNotEmpty()) {
        append("<h2>Done</h2>\n")
        appendItems(done)
    }
    append("</body>\n</html>\n")
}

/** Returns whether [begin], the first 1,000 characters of a file, belongs to a page of [toPage]. */
fun isTodoPage(begin: String): Boolean = GENERATOR in begin

private const val GENERATOR = "<meta name=\"generator\" content=\"badlog todo\">"

private fun StringBuilder.appendItems(items: List<TodoItem>) {
    append("<ul>\n")
    for (item in items) {
        val severity = item.found?.severity?.takeIf { item.isOpen }
        val kind = when (severity) {
            Severity.ERROR -> " class=\"error\""
            Severity.WARNING -> " class=\"warning\""
            else -> ""
        }
        append("<li$kind>${box(!item.isOpen)}<div><b>${html(item.title)}</b>")
        if (severity != null) append(" <span>${severity.word}</span>")
        if (item.person.isNotEmpty()) append(" <span>${html(item.person)}</span>")
        for (line in item.lines) append("<p>${html(line)}</p>")
        append("</div></li>\n")
    }
    append("</ul>\n")
}

private fun box(isTicked: Boolean) =
    if (isTicked) "<i role=\"img\" aria-label=\"done\">✓</i>" else "<i role=\"img\" aria-label=\"open\"></i>"

private fun html(text: String): String = buildString(text.length) {
    for (char in text) {
        when (char) {
            '&' -> append("&amp;")
            '<' -> append("&lt;")
            '>' -> append("&gt;")
            '"' -> append("&quot;")
            else -> append(char)
        }
    }
}

private const val STYLE = """
:root { color-scheme: light dark; --text: #1d2126; --muted: #5c6670; --line: #d5dae0; --page: #fff; --error: #b3261e; --warning: #8a5a00 }
@media (prefers-color-scheme: dark) {
  :root { --text: #e6e9ed; --muted: #9aa4af; --line: #3a424b; --page: #16191d; --error: #ff8a80; --warning: #ffc166 }
}
@media print {
  :root { --text: #000; --muted: #444; --line: #999; --page: #fff; --error: #b3261e; --warning: #8a5a00 }
}
body { margin: 0 auto; max-width: 46rem; padding: 1.5rem; background: var(--page); color: var(--text); font: 16px/1.45 system-ui, sans-serif }
h1 { font-size: 1.6rem; margin: 0 0 1rem; overflow-wrap: anywhere }
h2 { font-size: 1.15rem; margin: 2rem 0 .5rem }
ul { list-style: none; margin: 0; padding: 0 }
li { display: flex; gap: .75rem; padding: .6rem 0; border-top: 1px solid var(--line); break-inside: avoid }
li > div { min-width: 0; overflow-wrap: anywhere }
i { flex: none; width: 1.1rem; height: 1.1rem; margin-top: .15rem; border: 2px solid var(--muted); border-radius: 3px; font: 700 1rem/1.1rem system-ui; text-align: center }
p { margin: .15rem 0 0; color: var(--muted) }
span { color: var(--muted) }
.error b { color: var(--error) }
.warning b { color: var(--warning) }
"""

/** Returns the list and the [checklist] before the next match as Markdown, for a wiki or a chat. */
fun TodoList.toMarkdown(checklist: List<String> = emptyList()): String = buildString {
    append("# To do\n")
    if (open.isEmpty()) append("\nNothing is open.\n")
    for (item in open) append(itemText(item))
    val lines = checklist(checklist)
    if (lines.isNotEmpty()) append("\n## ${plain(checklistTitle(next))}\n")
    for (line in lines) {
        append(
            "\n- ${tick(line.done != null)} ${plain(line.check.text)}${line.done?.let {
                " (${plain(it.by)})"
            }.orEmpty()}",
        )
    }
    if (lines.isNotEmpty()) append('\n')
    if (done.isNotEmpty()) append("\n## Done\n")
    for (item in done) append(itemText(item))
}

private fun itemText(item: TodoItem): String = buildString {
    append("\n- ${tick(!item.isOpen)} **${plain(item.title)}**")
    if (item.person.isNotEmpty()) append(" (${plain(item.person)})")
    for (line in item.lines) append("  \n  ${plain(line)}")
    append('\n')
}

private fun tick(isTicked: Boolean) = if (isTicked) "[x]" else "[ ]"

/** Returns [text] with all signs of Markdown escaped, including mentions of people. */
private fun plain(text: String): String = text.replace(Regex("\\s+"), " ")
    .replace(SIGN) { "\\${it.value}" }
    .replace(SIGN_OF_LINE) { "${it.groupValues[1]}\\${it.groupValues[2]}" }

private val SIGN = Regex("[\\\\`*_\\[\\]<>#|~&@]")

/** The signs that make a list or a heading at the start of a line. */
private val SIGN_OF_LINE = Regex("^ ?([0-9]*)([-+=.)])")
