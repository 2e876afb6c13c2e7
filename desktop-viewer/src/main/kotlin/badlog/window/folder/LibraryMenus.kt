package badlog.window.folder

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Icon
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import badlog.catalog.folder.LogEntry
import badlog.signals.match.NaturalOrder
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.search.Query
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.SearchField
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import java.nio.file.Path

/** The folder's name, with a menu to open other folders, logs, and views. */
@Composable
internal fun FolderMenu(library: Library, settings: SettingsStore, actions: LibraryActions, modifier: Modifier = Modifier) {
    var isOpen by remember { mutableStateOf(false) }
    val folder = library.state.folder
    val line = @Composable { title: String, press: () -> Unit ->
        MenuLine(title) {
            isOpen = false
            press()
        }
    }
    val lines = @Composable {
        line("Open folder…") { actions.opener.askForFolder() }
        line("Open file…", actions.opener::askForLog)
        actions.closeLog()?.let { line("Close log", it) }
        if (folder != null) {
            HorizontalDivider()
            line("Pit view (I)", actions.togglePit)
            line("Batteries (Shift+B)", actions.toggleBatteries)
            line("To do (D)", actions.toggleTodo)
            MenuLine("Sound when a log arrives", Icons.Check.takeIf { settings.state.ringsForLogs }) {
                settings.change { copy(ringsForLogs = !ringsForLogs) }
            }
        }
        val others = settings.state.recentFolders.filter { it != folder?.toString() }
        if (others.isNotEmpty()) HorizontalDivider()
        for (recent in others) line(recent) { library.open(Path.of(recent)) }
    }
    MenuBox(isOpen, { isOpen = false }, modifier, lines) {
        Tip(folder?.toString() ?: "Open a folder of logs") {
            Row(
                Modifier
                    .clickable(role = Role.Button) { isOpen = !isOpen }
                    .semantics { contentDescription = "Folder" }
                    .padding(4.dp),
                horizontalArrangement = Arrangement.spacedBy(6.dp),
                verticalAlignment = Alignment.CenterVertically,
            ) {
                val palette = LocalPalette.current
                Icon(Icons.Folder, contentDescription = null, Modifier.size(16.dp), palette.muted)
                NameText(
                    folder?.let(::nameOf) ?: "No folder",
                    Modifier.weight(1f, fill = false),
                    fontWeight = FontWeight.SemiBold,
                    cut = NameCut.MIDDLE,
                )
                Icon(Icons.Down, contentDescription = null, Modifier.size(12.dp), palette.muted)
            }
        }
    }
}

/** The menu for sorting the list. */
@Composable
internal fun SortMenu(library: Library) {
    var isOpen by remember { mutableStateOf(false) }
    val listing = library.state.listing
    val lines = @Composable {
        for (column in LogColumn.entries) {
            val mark = if (column != listing.column) {
                null
            } else if (listing.isDescending) {
                Icons.Down
            } else {
                Icons.Up
            }
            MenuLine(column.title, mark) { library.change { sorted(column) } }
        }
    }
    MenuBox(isOpen, { isOpen = false }, menu = lines) {
        ToolButton("Sort logs", Icons.Sort, isOn = isOpen) { isOpen = !isOpen }
    }
}

private fun nameOf(folder: Path): String = folder.fileName?.toString() ?: folder.toString()

/** The menu for the topic in the previews of logs. */
@Composable
internal fun PreviewMenu(entries: List<LogEntry>, settings: SettingsStore) {
    var isOpen by remember { mutableStateOf(false) }
    MenuBox(isOpen, { isOpen = false }, menu = { PreviewChoice(entries, settings) { isOpen = false } }) {
        ToolButton("Preview: ${settings.state.previewTopic ?: BATTERY}", Icons.Graph, isOn = isOpen) { isOpen = !isOpen }
    }
}

@Composable
private fun PreviewChoice(entries: List<LogEntry>, settings: SettingsStore, onSelected: () -> Unit) {
    var filter by remember { mutableStateOf("") }
    val names = remember(entries) {
        entries.flatMapTo(HashSet()) { entry -> entry.summary.topics.map { it.name } }.sortedWith(NaturalOrder)
    }
    val shown = remember(names, filter) { names.filter(Query(filter)::matches) }
    // A menu measures its content before it knows its size, which a lazy list needs to know.
    Column(Modifier.width(280.dp).padding(horizontal = 8.dp)) {
        SearchField(filter, "Search topics for the preview") { filter = it }
        LazyColumn(Modifier.width(264.dp).height(320.dp)) {
            fun select(name: String?) {
                settings.change { copy(previewTopic = name) }
                onSelected()
            }
            val selected = settings.state.previewTopic
            if (filter.isEmpty()) item { MenuLine(BATTERY, Icons.Check.takeIf { selected == null }) { select(null) } }
            items(shown) { name -> MenuLine(name, Icons.Check.takeIf { selected == name }) { select(name) } }
        }
    }
}

private const val BATTERY = "the battery’s voltage"
