package badlog.window.app

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.wrapContentWidth
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.input.HelpLine
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.theme.sheet

/** The help for keyboard and pointer; shown above the window, which stays active behind it. */
@Composable
internal fun HelpSheet(help: List<HelpLine>, modifier: Modifier = Modifier, onClose: () -> Unit) {
    Column(modifier.sheet("Keys and gestures sheet", widest = 960.dp)) {
        Row(Modifier.fillMaxWidth().padding(start = 20.dp, end = 8.dp, top = 8.dp), verticalAlignment = Alignment.CenterVertically) {
            Text("Keys and gestures", Modifier.weight(1f), fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
            ToolButton("Close the sheet", Icons.Close, onClick = onClose)
        }
        val groups = help.groupBy { it.group }
        val scroll = rememberScrollState()
        Box {
            FlowRow(
                Modifier.verticalScroll(scroll).padding(start = 20.dp, end = 20.dp, bottom = 16.dp),
                Arrangement.spacedBy(28.dp),
            ) {
                for (column in inTwoColumns(groups)) {
                    Column(Modifier.width(440.dp)) {
                        for ((title, lines) in column) HelpGroup(title, lines)
                    }
                }
            }
            VerticalScrollbar(rememberScrollbarAdapter(scroll), Modifier.matchParentSize().wrapContentWidth(Alignment.End))
        }
    }
}

/** Returns [groups] in two columns of about the same height, in order. */
private fun inTwoColumns(groups: Map<String, List<HelpLine>>): List<List<Map.Entry<String, List<HelpLine>>>> {
    val all = groups.values.sumOf { it.size + 1 }
    var before = 0
    val (first, second) = groups.entries.partition { (_, lines) ->
        val isInFirst = before + lines.size / 2 <= all / 2
        before += lines.size + 1
        isInFirst
    }
    return listOf(first, second)
}

@Composable
private fun HelpGroup(title: String, lines: List<HelpLine>) {
    Column(Modifier.padding(top = 10.dp)) {
        Text(title, Modifier.padding(bottom = 4.dp), fontWeight = FontWeight.SemiBold)
        for ((_, how, meaning) in lines) {
            Row(Modifier.fillMaxWidth().padding(vertical = 2.dp), Arrangement.spacedBy(10.dp)) {
                Text(how, Modifier.width(130.dp), LocalPalette.current.accent)
                Text(meaning, Modifier.weight(1f))
            }
        }
    }
}
