package badlog.window.battery

import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.unit.dp
import badlog.viewer.shown.battery.BatteryMatch
import badlog.window.menu.MenuBox
import badlog.window.menu.MenuLine
import badlog.window.theme.Icons
import badlog.window.theme.SearchField
import badlog.window.theme.ToolButton

/** A menu for changing the battery of a match from [name]. It offers [names], and a field for typing another name. */
@Composable
internal fun BatteryField(match: BatteryMatch, name: String, names: List<String>, onName: (String) -> Unit) {
    var isOpen by remember { mutableStateOf(false) }
    var typed by remember { mutableStateOf("") }
    fun choose(chosen: String) {
        isOpen = false
        typed = ""
        onName(chosen)
    }
    val lines = @Composable {
        SearchField(
            typed,
            "Name of the battery",
            Modifier.width(180.dp).onPreviewKeyEvent {
                val isDone = it.type == KeyEventType.KeyDown && it.key == Key.Enter && typed.isNotBlank()
                if (isDone) choose(typed)
                isDone
            },
            Icons.Note,
        ) { typed = it }
        for (each in names.filter { it.contains(typed, ignoreCase = true) }.take(MAX_NAMES)) {
            MenuLine(each, Icons.Check.takeIf { each == name }) { choose(each) }
        }
        if (name.isNotEmpty()) MenuLine("As the log says") { choose("") }
    }
    MenuBox(isOpen, { isOpen = false }, menu = lines) {
        ToolButton("Battery of ${match.title}", Icons.Down, text = if (name.isEmpty()) "Name…" else "Change…") { isOpen = !isOpen }
    }
}

private const val MAX_NAMES = 12
