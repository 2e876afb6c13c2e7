package badlog.html

/** What every page begins with, in ASCII. */
internal const val PAGE_START = "<!DOCTYPE html"

/** [text] as it may stand between HTML tags, or in an attribute in double quotes, and nowhere become a tag. */
internal fun escapeHtml(text: String): String = text
    .replace("&", "&amp;")
    .replace("<", "&lt;")
    .replace(">", "&gt;")
    .replace("\"", "&quot;")
