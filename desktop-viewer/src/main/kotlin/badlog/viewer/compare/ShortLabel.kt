package badlog.viewer.compare

/** [label] in at most [letters], without its middle where it is longer: matches of one event differ at their end. */
internal fun shortLabel(label: String, letters: Int): String {
    if (label.length <= letters) return label
    val end = (letters - 1) / 2
    return label.take(letters - 1 - end).trimEnd() + "…" + label.takeLast(end).trimStart()
}
