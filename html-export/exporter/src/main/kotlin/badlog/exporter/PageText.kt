package badlog.exporter

/** The beginning of every page, in ASCII. */
internal const val PAGE_START = "<!DOCTYPE html"

/** Returns [text] escaped for use between HTML tags or in a double-quoted attribute. */
internal fun escapeHtml(text: String): String = text
    .replace("&", "&amp;")
    .replace("<", "&lt;")
    .replace(">", "&gt;")
    .replace("\"", "&quot;")
