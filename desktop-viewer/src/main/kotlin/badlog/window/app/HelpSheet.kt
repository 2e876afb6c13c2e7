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
import badlog.viewer.input.GRAPH_GESTURES
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

/** The help for gestures of the pointer. Over graphs, most gestures are the same as on an exported page. */
internal val GESTURES = GRAPH_GESTURES + listOf(
    HelpLine("On the graphs", "Click in a legend", "Hides the line, or shows it again."),
    HelpLine("On the graphs", "Drag a title", "Moves the graph; dropped on another graph, adds its lines to that one."),
    HelpLine("On the graphs", "Right click a title, Shift+F10", "Opens a menu: show only this graph, change its height or its y limits."),
    HelpLine("On the graphs", "Ctrl+drag", "Selects a range, like a drag with the right button."),
    HelpLine("On the graphs", "Middle button", "Pans, like a drag on the axis."),
    HelpLine("On the graphs", "Ctrl+Shift+wheel", "Makes all graphs taller or shorter."),
    HelpLine("Topics", "Click", "Draws the topic in its own graph; click again to remove it."),
    HelpLine("Topics", "Ctrl+click, Shift+click", "Selects one more topic, or all topics up to this one."),
    HelpLine("Topics", "Drag", "Adds the topic, or all selected ones, to a graph."),
    HelpLine("Topics", "Right click, Shift+F10", "Opens a menu with more actions, also for a folder."),
    HelpLine("Events", "Click", "Moves the cursor to the event."),
    HelpLine("Findings", "Point at a mark, click", "Shows the finding, and moves the cursor there."),
    HelpLine("Statistics table", "Click a heading", "Sorts by it; again, in reverse."),
    HelpLine("Statistics table", "Double-click a row", "Opens its log."),
)
