package badlog.viewer.formula

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.theme.LocalPalette

/** What a formula may be made of, in a few lines. */
@Composable
internal fun FormulaHelp() {
    val palette = LocalPalette.current
    Column(Modifier.padding(top = 4.dp)) {
        for (line in ESSENTIALS) {
            Text(line, color = palette.muted, fontFamily = FontFamily.Monospace, fontSize = 11.sp, lineHeight = 16.sp)
        }
        Text(REST, color = palette.muted, fontSize = 11.sp)
    }
}

private const val REST = "Names with odd signs stand in \"quotes\". All of the language is in docs/expressions.md."

private val ESSENTIALS = listOf(
    "Power [W] = Battery Voltage * Total Current",
    "+ - * / % ^  < > == and or not  x when enabled  if(c, a, b)",
    "mean(x, 1 s)  derivative(x)  area(x)  delta(x)  shift(x, 0.1 s)  abs(x)",
)
