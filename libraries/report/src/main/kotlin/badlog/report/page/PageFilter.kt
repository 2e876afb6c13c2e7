package badlog.report.page

import badlog.core.recording.Severity

/** Returns the fields that filter the page, or order it by [groups]; hidden until the page's script shows them. */
internal fun filterForm(logs: List<IndexedLog>, groups: List<MatchGroup>): String {
    val out = StringBuilder("<form id=\"filter\" role=\"search\" aria-label=\"Filter\" hidden=\"\">\n")
    out.append("<label>Search <input type=\"search\" name=\"words\" autocomplete=\"off\"/></label>\n")
    val levels = listOf("Everything" to 0, "Warnings and errors" to Severity.WARNING.ordinal, "Errors" to Severity.ERROR.ordinal)
    out.append(selection("Severity", "level", levels.map { (text, level) -> text to "$level" }))
    val types = logs.mapNotNull { it.report.matchType }.distinct().sorted()
    if (types.size > 1) out.append(selection("Type", "type", listOf("All" to "") + types.map { it to it }))
    if (groups.size > 1) out.append(selection("Order", "order", listOf("Worst first" to "", "By event and match" to "event")))
    return out.append("<output name=\"found\" role=\"status\"></output>\n</form>\n").toString()
}

private fun selection(label: String, name: String, options: List<Pair<String, String>>): String {
    val choices = options.joinToString("") { (text, value) -> "<option value=\"${escaped(value)}\">${escaped(text)}</option>" }
    return "<label>$label <select name=\"$name\">$choices</select></label>\n"
}
