package badlog.page.folder

/**
 * A folder in the tree of all folders.
 *
 * @property title its name in the tree; for a folder that contains only one folder, both names.
 * @property section its content; null if it contains only folders.
 */
internal class FolderTree private constructor(val title: String, val section: FolderSection?, val folders: List<FolderTree>) {
    /** Its own section, and the sections of its folders. */
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
        /** Returns the folders of [sections], in order. The folder of a hook is separate. */
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
