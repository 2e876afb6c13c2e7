package badlog.window.panel

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import badlog.viewer.panel.Value
import badlog.viewer.state.Action
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Tip

/** Shows [value] between its buttons: icons, as small as its text, come first. */
@Composable
internal fun ValueView(value: Value, send: (Action) -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth()
            .background(if (value.isMarked) palette.accentSoft else Color.Transparent)
            .padding(start = 12.dp, end = 14.dp, top = 1.dp, bottom = 1.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        val (words, icons) = value.tools.partition { it.icon == null }
        for (tool in icons) {
            val icon = tool.icon?.vector ?: continue
            val press = Modifier.size(14.dp).clickable(role = Role.Button) { send(tool.action) }
            Icon(icon, tool.hint, press, if (tool.isOn == true) palette.accent else palette.muted)
        }
        value.color?.let { Box(Modifier.size(10.dp).background(palette.line(it), RoundedCornerShape(2.dp))) }
        NameText(value.name, Modifier.weight(1f), color = palette.muted)
        value.field?.let { FieldView(it, send) } ?: Tip(value.exact, Modifier.weight(0.8f)) {
            Text(value.text, fontWeight = FontWeight.Medium, maxLines = 1, overflow = TextOverflow.Ellipsis)
        }
        ButtonsView(words, send)
    }
}
