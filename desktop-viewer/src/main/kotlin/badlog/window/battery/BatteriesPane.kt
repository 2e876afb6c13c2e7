package badlog.window.battery

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.HorizontalDivider
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
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.shown.battery.AdvisedBattery
import badlog.viewer.shown.battery.BatteryColumn
import badlog.viewer.shown.battery.BatteryMatch
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.BatteryStep
import badlog.window.folder.Library
import badlog.window.folder.LibraryActions
import badlog.window.folder.ReadingLine
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton

/** The team's batteries in the folder's logs, with advice, and the matches of each. */
@Composable
internal fun BatteriesPane(season: FolderSeason, library: Library, actions: LibraryActions, modifier: Modifier = Modifier) {
    val batteries = season.state
    LaunchedEffect(season) { season.refresh() }
    Column(modifier.background(LocalPalette.current.surface).semantics { contentDescription = "Batteries" }) {
        Row(Modifier.fillMaxWidth().padding(8.dp), Arrangement.SpaceBetween, Alignment.CenterVertically) {
            Text("Batteries", Modifier.padding(start = 4.dp), fontSize = 16.sp, fontWeight = FontWeight.SemiBold)
            ToolButton("Back to the graphs", Icons.Graph, text = "Graphs") { actions.showGraphs() }
        }
        HorizontalDivider()
        ReadingLine(library)
        for (problem in batteries.problems) Text(problem, Modifier.padding(12.dp), color = LocalPalette.current.warning)
        if (batteries.seasons.isEmpty()) {
            val hint = if (library.state.reading != null) "Reading the logs…" else "No log in this folder shows its battery."
            Text(hint, Modifier.padding(16.dp), color = LocalPalette.current.muted)
        } else {
            SeasonTable(batteries, library, season, actions)
        }
    }
}

@Composable
private fun SeasonTable(batteries: Batteries, library: Library, season: FolderSeason, actions: LibraryActions) {
    var opened by remember { mutableStateOf(emptySet<String>()) }
    val columns = BatteryColumn.of(batteries.seasons)
    val list = rememberLazyListState()
    BoxWithConstraints(Modifier.fillMaxSize()) {
        val width = maxOf(maxWidth, columns.sumOf { it.width }.dp + FOLD + MARGINS)
        LazyColumn(Modifier.fillMaxSize().horizontalScroll(rememberScrollState()).width(width).padding(horizontal = 12.dp), list) {
            item { Advice(batteries) }
            item { Head(columns) }
            for (each in batteries.seasons) {
                val isOpen = each.key in opened
                item(key = each.key) {
                    SeasonRow(each, columns, batteries.advice.of(each), isOpen) {
                        opened =
                            if (isOpen) opened - each.key else opened + each.key
                    }
                }
                if (isOpen) {
                    items(each.matches, key = { "${each.key}\n${it.paths.first()}" }) { match ->
                        val entry = library.state.entries.find { it.path == match.paths.first() }
                        MatchRow(match, each, batteries.names, columns, { entry?.let(actions.openInGraphs) }) { season.assign(it, match) }
                    }
                }
            }
        }
        VerticalScrollbar(rememberScrollbarAdapter(list), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
    }
}

/** The advice on the batteries, the most urgent first, in large letters. It is read while the robot is on its cart. */
@Composable
private fun Advice(batteries: Batteries) = Column(Modifier.padding(vertical = 12.dp), Arrangement.spacedBy(6.dp)) {
    val palette = LocalPalette.current
    with(batteries.advice) {
        next?.let { Text(it.headline, fontSize = 24.sp, fontWeight = FontWeight.Bold) }
        next?.let { Text(it.reason, color = palette.muted) }
        for (each in retire + charge) Text(each.text, color = palette.colorOf(each.step))
    }
    if (batteries.names.isEmpty()) {
        Text(
            "No log says which battery was in the robot. Open the list below and type it beside each match, or let the robot log a value " +
                "“Battery Name”.",
            color = palette.muted,
        )
    }
}

@Composable
private fun Head(columns: List<BatteryColumn>) =
    Row(Modifier.fillMaxWidth().background(LocalPalette.current.raised).padding(start = FOLD, top = 6.dp, bottom = 6.dp)) {
        for (column in columns) {
            Tip(column.meaning) {
                Cell(column, column.title, isBold = true)
            }
        }
    }

@Composable
private fun SeasonRow(season: BatterySeason, columns: List<BatteryColumn>, advice: AdvisedBattery?, isOpen: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier
            .fillMaxWidth()
            .clickable(season.matches.isNotEmpty(), if (isOpen) "Hide its matches" else "Show its matches", Role.Button, onClick = onToggle)
            .semantics {
                contentDescription = "Battery ${season.title}"
                stateDescription =
                    columns.drop(1).mapNotNull { column -> column.text(season)?.let { "${column.title} $it" } }.joinToString()
            }
            .padding(vertical = 6.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Box(Modifier.width(FOLD)) {
            if (season.matches.isNotEmpty()) Icon(if (isOpen) Icons.Down else Icons.Right, null, Modifier.size(14.dp), palette.muted)
        }
        for (column in columns) Cell(column, column.text(season).orEmpty(), isBold = column == BatteryColumn.BATTERY)
        val label = if (season.battery?.isRetired == true) "Retired" else advice?.step?.label
        if (label != null) Tip(advice?.reason.orEmpty()) { AdviceLabel(label, isNext = advice?.step == BatteryStep.USE) }
    }
}

@Composable
private fun AdviceLabel(label: String, isNext: Boolean) {
    val palette = LocalPalette.current
    Text(
        label,
        Modifier
            .padding(start = 12.dp)
            .background(if (isNext) palette.accentSoft else palette.raised, RoundedCornerShape(4.dp))
            .padding(horizontal = 6.dp),
        color = if (isNext) palette.accent else palette.text,
        fontSize = 12.sp,
    )
}

/** A match in the columns of its battery, with a menu to change the battery's name. */
@Composable
private fun MatchRow(
    match: BatteryMatch,
    season: BatterySeason,
    names: List<String>,
    columns: List<BatteryColumn>,
    onOpen: () -> Unit,
    onName: (String) -> Unit,
) {
    val palette = LocalPalette.current
    val own = remember(match) { BatterySeason(null, listOf(match)) }
    Row(Modifier.fillMaxWidth().padding(start = FOLD, top = 2.dp, bottom = 2.dp), verticalAlignment = Alignment.CenterVertically) {
        Column(Modifier.width((BatteryColumn.BATTERY.width + BatteryColumn.MATCHES.width).dp)) {
            NameText(
                match.title,
                Modifier.clickable(
                    role = Role.Button,
                    onClickLabel = "Show the graphs of ${match.title}",
                    onClick = onOpen,
                ).padding(start = 8.dp),
                color = palette.accent,
                cut = NameCut.MIDDLE,
            )
        }
        for (column in columns.filter { it.isOfMatch }) Cell(column, column.text(own).orEmpty(), color = palette.muted)
        BatteryField(match, season.battery?.name.orEmpty(), names, onName)
    }
}

@Composable
private fun Cell(column: BatteryColumn, text: String, isBold: Boolean = false, color: Color = LocalPalette.current.text) {
    val place = Modifier.width(column.width.dp).padding(horizontal = 8.dp)
    val weight = if (isBold) FontWeight.SemiBold else FontWeight.Normal
    // A number is never shortened: without a part, it would be another one.
    if (column.isNumber) {
        Text(text, place, color, fontWeight = weight, textAlign = TextAlign.End, maxLines = 1)
    } else {
        NameText(text, place, color, fontWeight = weight, cut = NameCut.MIDDLE)
    }
}

/** Whether the row of a match has this column, too, below the row of its battery. */
private val BatteryColumn.isOfMatch get() = this != BatteryColumn.BATTERY && this != BatteryColumn.MATCHES

private val BatteryColumn.width: Int get() = when (this) {
    BatteryColumn.BATTERY -> 140
    BatteryColumn.RESISTANCE, BatteryColumn.GROWTH -> 130
    BatteryColumn.MATCHES, BatteryColumn.LOWEST, BatteryColumn.AGE -> 90
    else -> 104
}

private val FOLD = 20.dp
private val MARGINS = 140.dp
