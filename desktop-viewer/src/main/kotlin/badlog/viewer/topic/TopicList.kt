package badlog.viewer.topic

/**
 * How the list of topics is shown. Never changes; each transition gives a new one.
 *
 * @property query words that must be in the full name of what is listed, regardless of case.
 * @property folded the paths of the folders that are closed; a search opens them all.
 * @property chosen the names of the signals that are chosen, in the order in which they were.
 */
internal data class TopicList(val query: String = "", val folded: Set<String> = emptySet(), val chosen: List<String> = emptyList()) {
    /** Closes folder [path], or opens it. */
    fun toggledFolder(path: String): TopicList = copy(folded = if (path in folded) folded - path else folded + path)

    /** Chooses [name], or no longer. */
    fun toggled(name: String): TopicList = copy(chosen = if (name in chosen) chosen - name else chosen + name)

    /** Chooses all of [rows] from the one chosen last to [name], in the order in which they are listed. */
    fun chosenTo(name: String, rows: List<TopicRow>): TopicList {
        val listed = rows.filterIsInstance<SignalRow>().map { it.signal.name }
        val from = listed.indexOf(chosen.lastOrNull())
        val to = listed.indexOf(name)
        if (from < 0 || to < 0) return toggled(name)
        val between = if (from <= to) listed.subList(from, to + 1) else listed.subList(to, from + 1).reversed()
        return copy(chosen = (chosen - between.toSet()) + between)
    }
}
