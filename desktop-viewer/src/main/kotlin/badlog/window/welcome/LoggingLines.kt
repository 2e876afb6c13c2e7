package badlog.window.welcome

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontFamily
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The code that makes a robot's program log, in the selected language; [isWide] if there is room beside the lines. */
@Composable
internal fun LoggingLines(isWide: Boolean) {
    var language by remember { mutableStateOf(LoggingLanguage.JAVA) }
    Column(verticalArrangement = Arrangement.spacedBy(6.dp)) {
        Row(horizontalArrangement = Arrangement.spacedBy(4.dp)) {
            for (one in LoggingLanguage.entries) {
                ToolButton("Show the lines in ${one.title}", text = one.title, isOn = one == language) { language = one }
            }
        }
        for ((place, code) in language.lines) {
            if (isWide) {
                Row {
                    Place(place, Modifier.width(140.dp).padding(vertical = 4.dp))
                    Code(code, Modifier.weight(1f))
                }
            } else {
                Column {
                    Place(place, Modifier)
                    Code(code, Modifier.fillMaxWidth())
                }
            }
        }
        Text(
            "How to install the logger, and what else it does: the guide docs/${language.guide}, also in the download badlog-docs.",
            color = LocalPalette.current.muted,
            fontSize = 12.sp,
            lineHeight = 16.sp,
        )
    }
}

@Composable
private fun Place(text: String, modifier: Modifier) = Text(text, modifier, color = LocalPalette.current.muted, fontSize = 12.sp)

@Composable
private fun Code(code: String, modifier: Modifier) = SelectionContainer(modifier) {
    Text(
        code,
        Modifier
            .background(LocalPalette.current.raised, RoundedCornerShape(4.dp))
            .horizontalScroll(rememberScrollState())
            .padding(horizontal = 8.dp, vertical = 4.dp),
        fontFamily = FontFamily.Monospace,
        fontSize = 12.sp,
        softWrap = false,
    )
}
