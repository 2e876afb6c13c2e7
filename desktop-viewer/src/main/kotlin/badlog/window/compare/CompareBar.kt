package badlog.window.compare

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Heading
import badlog.viewer.panel.comparePanel
import badlog.viewer.state.Action
import badlog.window.panel.ButtonsView
import badlog.window.panel.PartView
import badlog.window.theme.LocalPalette

/** The logs compared with the open one, see [comparePanel]. */
@Composable
internal fun CompareBar(compared: ComparedRecordings, send: (Action) -> Unit) {
    val drawn = compared.drawn.ifEmpty { return }
    val comparison = compared.state
    val open = drawn.first()
    val reading = comparison.checked.filter { it != open.recording.file && it !in comparison.loaded }
    val parts = comparePanel(comparison.offsets.alignment, open.name, drawn.drop(1), reading.map { "${it.fileName}" })
    Column(Modifier.fillMaxWidth().background(LocalPalette.current.surface)) {
        for (part in parts) {
            when (part) {
                is Heading -> Unit

                is Choice -> Row(verticalAlignment = Alignment.CenterVertically) {
                    PartView(part, send, Modifier.weight(1f))
                    ButtonsView(parts.firstNotNullOf { it as? Heading }.tools, send, areIcons = true)
                }

                else -> Column(Modifier.heightIn(max = 140.dp).verticalScroll(rememberScrollState())) { PartView(part, send) }
            }
        }
        if (parts.isNotEmpty()) HorizontalDivider()
    }
}
