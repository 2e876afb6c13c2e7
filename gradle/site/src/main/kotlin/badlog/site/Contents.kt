package badlog.site

/** The sections of the site, as the guides' list of contents has them. */
internal class Contents(val sections: List<Section>) {
    /** A part of the site that answers one need. */
    data class Section(val title: String, val entries: List<Entry>)

    /** A page in the contents: its short [title], and the [address] on the site or elsewhere. */
    data class Entry(val title: String, val address: String)

    /** The entry of the page at [address], or null. */
    fun entry(address: String): Entry? = sections.firstNotNullOfOrNull { section -> section.entries.find { it.address == address } }

    internal companion object {
        /**
         * The contents that [guide] lists: a section for each heading of the second level, an entry for the first link of each of its list items.
         */
        fun of(guide: Guide): Contents = Contents(
            guide.lists.map { (heading, links) -> Section(heading, links.map { (text, address) -> Entry(text, address) }) },
        )
    }
}
