package badlog.site

/**
 * A Markdown file as a page.
 *
 * @property path its path in the repository.
 * @property address its address on the site.
 * @property title its first heading.
 * @property summary its first paragraph, as plain text.
 * @property html the content of the page.
 * @property sections its sections by headings, in order; the first one begins with the title.
 * @property lists for each heading of the second level, the first link of each list item below it: its text and address.
 * @property copied the files of the repository that it links to, each with its address.
 */
internal class Guide(
    val path: String,
    val address: String,
    val title: String,
    val summary: String,
    val html: String,
    val sections: List<Section>,
    val lists: List<Pair<String, List<Pair<String, String>>>>,
    val copied: Map<String, String>,
) {
    /** A heading of [level] with its [anchor], and the plain [text] below it, up to the next heading. */
    data class Section(val level: Int, val anchor: String, val heading: String, val text: String)
}
