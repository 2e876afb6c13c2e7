package badlog.window.battery

import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.shown.battery.BatteryStep
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** The advice on batteries, in letters that can be read from two meters away; empty if there is none. */
@Composable
internal fun PitBatteries(batteries: Batteries, onOpen: () -> Unit) {
    val palette = LocalPalette.current
    val lines = batteries.advice.inPit
    if (lines.isEmpty()) return
    Column(
        Modifier.fillMaxWidth().clickable(role = Role.Button, onClickLabel = "Show the batteries", onClick = onOpen),
        Arrangement.spacedBy(4.dp),
    ) {
        for (line in lines) Line(line.pitText, palette.colorOf(line.step))
    }
}

@Composable
private fun Line(text: String, color: Color) =
    Text(text, color = color, fontSize = 28.sp, lineHeight = 35.sp, fontWeight = FontWeight.SemiBold, maxLines = 1)

/** Returns the color of advice to take [step]. */
internal fun Palette.colorOf(step: BatteryStep): Color = when (step) {
    BatteryStep.USE -> text
    BatteryStep.RETIRE -> error
    BatteryStep.CHECK -> warning
}
