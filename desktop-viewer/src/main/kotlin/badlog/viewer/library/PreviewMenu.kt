package badlog.viewer.library

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.material3.DropdownMenu
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.file.NaturalOrder
import badlog.viewer.app.Viewer
import badlog.viewer.menu.MenuLine
import badlog.viewer.theme.Icons
import badlog.viewer.theme.SearchField
import badlog.viewer.theme.ToolButton

/** Of which topic the logs show a small line. */
@Composable
internal fun PreviewMenu(viewer: Viewer) {
    var isOpen by remember { mutableStateOf(false) }
    Box {
        ToolButton("Small line: ${viewer.settings.previewTopic ?: BATTERY}", Icons.Graph) { isOpen = true }
        DropdownMenu(isOpen, onDismissRequest = { isOpen = false }) { PreviewChoice(viewer) { isOpen = false } }
    }
}

@Composable
private fun PreviewChoice(viewer: Viewer, onChosen: () -> Unit) {
    var filter by remember { mutableStateOf("") }
    val entries = viewer.library.entries
    val names = remember(entries) {
        entries.flatMapTo(HashSet()) { entry -> entry.topics.map { it.name } }.sortedWith(NaturalOrder)
    }
    val shown = names.filter { filter.lowercase() in it.lowercase() }
    // A menu measures its content before it knows its size, which a lazy list needs to be told.
    Column(Modifier.width(280.dp).padding(horizontal = 8.dp)) {
        SearchField(filter, "Search topics for the small line") { filter = it }
        LazyColumn(Modifier.width(264.dp).height(320.dp)) {
            fun choose(name: String?) {
                viewer.settings = viewer.settings.copy(previewTopic = name)
                onChosen()
            }
            val chosen = viewer.settings.previewTopic
            if (filter.isEmpty()) item { MenuLine(BATTERY, Icons.Check.takeIf { chosen == null }) { choose(null) } }
            items(shown) { name -> MenuLine(name, Icons.Check.takeIf { chosen == name }) { choose(name) } }
        }
    }
}

private const val BATTERY = "the battery’s voltage"
