package badlog.viewer.todo

/** Returns the list and the [checklist] before the next match as Markdown, for a wiki or a chat. */
fun TodoList.toMarkdown(checklist: List<String> = emptyList()): String = buildString {
    append("# To do\n")
    if (open.isEmpty()) append("\nNothing is open.\n")
    for (item in open) append(itemText(item))
    val lines = checklist(checklist)
    if (lines.isNotEmpty()) append("\n## ${plain(checklistTitle(next))}\n")
    for (line in lines) {
        append(
            "\n- ${box(line.done != null)} ${plain(line.check.text)}${line.done?.let {
                " (${plain(it.by)})"
            }.orEmpty()}",
        )
    }
    if (lines.isNotEmpty()) append('\n')
    if (done.isNotEmpty()) append("\n## Done\n")
    for (item in done) append(itemText(item))
}

private fun itemText(item: TodoItem): String = buildString {
    append("\n- ${box(!item.isOpen)} **${plain(item.title)}**")
    if (item.person.isNotEmpty()) append(" (${plain(item.person)})")
    for (line in item.lines) append("  \n  ${plain(line)}")
    append('\n')
}

private fun box(isTicked: Boolean) = if (isTicked) "[x]" else "[ ]"

/** Returns [text] with all signs of Markdown escaped, including mentions of people. */
private fun plain(text: String): String = text.replace(Regex("\\s+"), " ")
    .replace(SIGN) { "\\${it.value}" }
    .replace(SIGN_OF_LINE) { "${it.groupValues[1]}\\${it.groupValues[2]}" }

private val SIGN = Regex("[\\\\`*_\\[\\]<>#|~&@]")

/** The signs that make a list or a heading at the start of a line. */
private val SIGN_OF_LINE = Regex("^ ?([0-9]*)([-+=.)])")
