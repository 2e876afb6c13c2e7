package badlog.page.folder

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.isNarrow
import badlog.page.dom.showText
import badlog.viewer.shown.outline.MAX_OPEN_FOLDERS
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLSelectElement

/** The navigation between the folders. It is a tree beside them on a wide screen, and a drop-down list in the bar on a narrow one. */
internal class FolderNavigation(private val folders: FolderList) {
    private val links = ArrayList<Pair<HTMLElement, FolderSection>>()
    private val counts = ArrayList<Pair<HTMLElement, FolderSection>>()
    private val branches = ArrayList<Branch>()
    private lateinit var tree: HTMLElement

    val list: HTMLElement = element("nav", "folder-list") {
        setAttribute("aria-label", "Folders")
        add("div", "folder-list-head") {
            add("span", "", "Folders")
            addButton("text-button", "open all") { folders.openAll() }.id = "expand-all"
            addButton("text-button", "close all") { folders.closeAll() }.id = "collapse-all"
        }
        tree = add("div")
    }

    val choice: HTMLElement = element("select", "folder-choice") {
        setAttribute("aria-label", "Go to a folder")
        addEventListener("change", {
            val select = unsafeCast<HTMLSelectElement>()
            folders.sections.getOrNull(select.selectedIndex - 1)?.reveal()
            select.selectedIndex = 0
        })
    }

    init {
        list()
    }

    /** Lists the current folders. */
    fun list() {
        tree.textContent = ""
        links.clear()
        counts.clear()
        branches.clear()
        choice.textContent = ""
        choice.add("option", "", if (isNarrow) "Folders" else "Go to folder…")
        for (section in folders.sections) choice.add("option", "", section.shortCaption)
        val isOpen = folders.sections.size <= MAX_OPEN_FOLDERS
        for (folder in FolderTree.of(folders.sections)) tree.addFolder(folder, isOpen)
    }

    /** Shows only the links to visible folders, with their current counts; opens all branches if [isSearching]. */
    fun update(isSearching: Boolean) {
        for ((link, section) in links) link.isHidden = section.element.isHidden
        for ((count, section) in counts) count.showText(countText(section.count))
        for (branch in branches) branch.update(isSearching)
    }

    private fun HTMLElement.addFolder(folder: FolderTree, isOpen: Boolean) {
        val section = folder.section
        if (folder.folders.isEmpty()) {
            if (section != null) addLink(folder.title, section)
            return
        }
        val branch = Branch(folder, isOpen)
        branches += branch
        appendChild(branch.element)
        if (section == null) branch.head.add("span", "folder-link-name", folder.title) else branch.head.addLink(folder.title, section)
        for (inner in folder.folders) branch.body.addFolder(inner, isOpen)
    }

    private fun HTMLElement.addLink(title: String, section: FolderSection) {
        val link = addButton("folder-link", "", section.folder.name) { section.reveal() }.apply {
            add("span", "folder-link-name", title)
            counts += add("span", "count", countText(section.count)) to section
        }
        links += link to section
    }

    /** A folder that contains other folders. */
    private class Branch(private val folder: FolderTree, private var isOpen: Boolean) {
        private lateinit var toggle: HTMLElement
        lateinit var head: HTMLElement
        lateinit var body: HTMLElement

        val element: HTMLElement = element("div") {
            head = add("div", "folder-branch") {
                toggle = addIconButton("folder-fold", Icon.CHEVRON, "Folders in ${folder.title}") {
                    isOpen = !isOpen
                    show(isOpen)
                }
            }
            body = add("div", "folder-inner")
            show(isOpen)
        }

        fun update(isSearching: Boolean) {
            element.isHidden = folder.sections.all { it.element.isHidden }
            show(isOpen || isSearching)
        }

        private fun show(isShown: Boolean) {
            toggle.setAttribute("aria-expanded", isShown.toString())
            body.isHidden = !isShown
        }
    }
}

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

/** The link to the first event log, which explains a recording but is far below its graphs. */
internal class EventsLink(private val folders: FolderList) {
    private lateinit var count: HTMLElement

    val element: HTMLElement = element("button", "events-link") {
        setAttribute("type", "button")
        title = "Go to the event log"
        add("span", "", "Events")
        count = add("span", "count")
        addEventListener("click", { go() })
    }

    init {
        update()
    }

    /** Shows the current number of events. */
    fun update() {
        val found = folders.sections.sumOf { section -> section.tables.sumOf { it.foundCount } }
        element.isHidden = found == 0
        count.showText(countText(found))
    }

    private fun go() {
        for (section in folders.sections) {
            val table = section.tables.firstOrNull { it.foundCount > 0 } ?: continue
            section.reveal(table.element)
            table.focus()
            return
        }
    }
}
