package badlog.window.menu

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.relocation.BringIntoViewRequester
import androidx.compose.foundation.relocation.bringIntoViewRequester
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.vector.ImageVector
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.LocalWindowInfo
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.ToolButton

/**
 * One line of a [Menu].
 *
 * @property text its label.
 * @property hint details in small print; may be empty.
 * @property disabledReason the reason why it is currently not possible, shown instead of [hint]; null if it is possible.
 * @property keys its keyboard shortcut; may be empty.
 * @property keepsMenu whether the menu stays open.
 */
internal class MenuEntry(
    val text: String,
    val hint: String = "",
    val disabledReason: String? = null,
    val keys: String = "",
    val keepsMenu: Boolean = false,
    val action: () -> Unit,
)

/**
 * A button that opens a list of [entries]; it shows [label] if the window has room for that. One of the entries may open
 * [panel] in place of the list; the panel closes the menu with the function that it receives.
 */
@Composable
internal fun Menu(
    label: String,
    description: String,
    icon: ImageVector,
    panel: @Composable (close: () -> Unit) -> Unit = {},
    entries: (openPanel: () -> Unit) -> List<MenuEntry>,
) {
    var isOpen by remember { mutableStateOf(false) }
    var showsPanel by remember { mutableStateOf(false) }
    val close = {
        isOpen = false
        showsPanel = false
    }
    val isRoomy = LocalWindowInfo.current.containerSize.width >= with(LocalDensity.current) { ROOMY.toPx() }
    val lines = @Composable {
        Column(Modifier.width(MENU_WIDTH)) {
            if (showsPanel) {
                panel(close)
            } else {
                for (entry in entries { showsPanel = true }) {
                    EntryLine(entry) {
                        if (!entry.keepsMenu) close()
                        entry.action()
                    }
                }
            }
        }
    }
    MenuBox(isOpen, close, menu = lines) {
        ToolButton(description, icon, text = label.takeIf { isRoomy }, isOn = isOpen) { if (isOpen) close() else isOpen = true }
    }
}

@Composable
private fun EntryLine(entry: MenuEntry, onClick: () -> Unit) {
    val palette = LocalPalette.current
    val isEnabled = entry.disabledReason == null
    Row(
        Modifier
            .clickable(enabled = isEnabled, role = Role.Button, onClick = onClick)
            .semantics { contentDescription = entry.text }
            .padding(horizontal = 14.dp, vertical = 6.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Column(Modifier.weight(1f)) {
            val tint = if (isEnabled) palette.text else palette.muted.copy(alpha = 0.6f)
            NameText(entry.text, color = tint, cut = NameCut.MIDDLE)
            val small = entry.disabledReason ?: entry.hint
            if (small.isNotEmpty()) {
                Text(small, color = palette.muted, fontSize = 11.sp, maxLines = 2, overflow = TextOverflow.Ellipsis)
            }
        }
        if (entry.keys.isNotEmpty()) Text(entry.keys, color = palette.muted, fontSize = 11.sp, maxLines = 1)
    }
}

private val MENU_WIDTH = 320.dp
private val ROOMY = 900.dp

/** A line of a menu. The icon [mark] shows that it is selected. With [isMarked], it is highlighted, and Enter selects it. */
@Composable
internal fun MenuLine(text: String, mark: ImageVector? = null, isMarked: Boolean = false, onClick: () -> Unit) {
    val palette = LocalPalette.current
    val sight = remember { BringIntoViewRequester() }
    if (isMarked) LaunchedEffect(sight) { sight.bringIntoView() }
    Row(
        Modifier
            .bringIntoViewRequester(sight)
            .widthIn(min = 180.dp, max = 420.dp)
            .background(if (isMarked) palette.accentSoft else Color.Transparent)
            .border(2.dp, if (isMarked) palette.accent else Color.Transparent, RoundedCornerShape(4.dp))
            .semantics { if (isMarked) selected = true }
            .clickable(role = Role.Button, onClick = onClick)
            .padding(horizontal = 12.dp, vertical = 6.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        NameText(text, Modifier.weight(1f), cut = NameCut.MIDDLE)
        if (mark != null) Icon(mark, contentDescription = "selected", Modifier.size(14.dp), palette.accent)
    }
}
