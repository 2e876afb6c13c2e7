package badlog.site

/** The sections of the site, according to the guides' list of contents. */
internal class Contents(val sections: List<Section>) {
    /** A group of pages for one purpose. */
    data class Section(val title: String, val entries: List<Entry>)

    /** A page in the contents: its short [title], and the [address] on the site or elsewhere. */
    data class Entry(val title: String, val address: String)

    /** Returns the entry of the page at [address]; null if there is none. */
    fun entry(address: String): Entry? = sections.firstNotNullOfOrNull { section -> section.entries.find { it.address == address } }

    internal companion object {
        /**
         * Returns the contents listed in [guide]. Each heading of the second level is a section, and the first link of each of its list
         * items an entry.
         */
        fun of(guide: Guide): Contents = Contents(
            guide.lists.map { (heading, links) -> Section(heading, links.map { (text, address) -> Entry(text, address) }) },
        )
    }
}
