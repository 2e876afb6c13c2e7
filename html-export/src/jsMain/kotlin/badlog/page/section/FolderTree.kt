package badlog.page.section

/**
 * A folder in the tree of all folders.
 *
 * @property title what it is called there; of folders that hold nothing but one folder, both names.
 * @property section what is in it; null where only its folders have something.
 */
internal class FolderTree private constructor(val title: String, val section: FolderSection?, val folders: List<FolderTree>) {
    /** What is in it and in its folders. */
    val sections: List<FolderSection> get() = listOfNotNull(section) + folders.flatMap { it.sections }

    private class Draft(val title: String) {
        var section: FolderSection? = null
        val folders = LinkedHashMap<String, Draft>()

        fun toTree(above: String = ""): FolderTree {
            val name = above + title
            val only = folders.values.singleOrNull()
            if (section == null && only != null) return only.toTree("$name / ")
            return FolderTree(name, section, folders.values.map { it.toTree() })
        }
    }

    companion object {
        /** The folders of [sections], in their order; what a hook made stands by itself. */
        fun of(sections: List<FolderSection>): List<FolderTree> {
            val root = Draft("")
            for (section in sections) {
                val path = section.path
                var folder = root
                for (part in path) folder = folder.folders.getOrPut(part) { Draft(part) }
                folder.section = section
            }
            return root.folders.values.map { it.toTree() }
        }
    }
}
