package badlog.report.hook

/**
 * Returns whether [text] begins like an SVG picture: with its root, after anything that XML allows before the root. A document type that
 * defines entities is not accepted, since they may expand without bounds.
 */
internal fun beginsAsSvg(text: String): Boolean {
    var at = 0
    while (true) {
        while (at < text.length && text[at].isWhitespace()) at++
        val end = when {
            text.startsWith("<?", at) -> "?>"
            text.startsWith("<!--", at) -> "-->"
            text.startsWith("<!DOCTYPE", at) -> ">"
            else -> return text.startsWith(ROOT, at) && text.getOrNull(at + ROOT.length)?.let { it.isWhitespace() || it in "/>" } == true
        }
        val found = text.indexOf(end, at)
        if (found < 0 || (end == ">" && text.substring(at, found).contains('['))) return false
        at = found + end.length
    }
}

private const val ROOT = "<svg"
