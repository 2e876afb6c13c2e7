package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.produceState
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.draw.plot.HISTOGRAM_HEIGHT
import badlog.viewer.draw.plot.drawHistogram
import badlog.viewer.shown.statistics.ChannelOrder
import badlog.viewer.shown.statistics.Histogram
import badlog.viewer.shown.statistics.NamedDifference
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import badlog.window.compare.ComparedRecordings
import badlog.window.compare.DrawnRecording
import badlog.window.compare.colorOf
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.pen.pen
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The statistics of every drawn signal over the selection, otherwise between both cursors, otherwise over the visible range. */
@Composable
internal fun StatisticsPanel(
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    panels: WindowPanels,
    open: OpenRecording,
    modifier: Modifier,
) {
    var opened by remember { mutableStateOf<String?>(null) }
    val statistics by produceState<RangeStatistics?>(null, open) {
        // While the selection is dragged, only the latest that there was time for is calculated.
        snapshotFlow {
            statisticsInput(compared, board, view, spanOf(panels.state.statistics, open, view), panels.state.channels, opened)
        }.conflate().map { asked ->
            withContext(Dispatchers.Default) {
                asked.run { rangeStatistics(drawn, names, part, graphs, order, opened) }
            }
        }.collect { value = it }
    }
    val known = statistics ?: return
    val copy = rememberCopy()
    val state = rememberLazyListState()
    Column(modifier) {
        RangeChoice(panels, view, open)
        Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp, top = 4.dp), verticalAlignment = Alignment.CenterVertically) {
            Column(Modifier.weight(1f)) {
                Text(known.part.name, fontWeight = FontWeight.Medium)
                Text(rangeText(known), color = LocalPalette.current.muted, fontSize = 12.sp)
                Text(Statistic.BY_TIME, color = LocalPalette.current.muted, fontSize = 12.sp)
            }
            ToolButton("Copy the statistics", Icons.Copy, text = "Copy") { copy(known.toTsv()) }
        }
        if (known.signals.isEmpty()) PanelHint("No topic is drawn. Click one in the list of topics.")
        Box(Modifier.fillMaxSize()) {
            LazyColumn(Modifier.fillMaxSize(), state) {
                items(known.signals) { signal ->
                    SignalCells(signal, signal.signal == known.opened) { opened = if (opened == signal.signal) null else signal.signal }
                }
                if (known.channels.isNotEmpty()) item { ChannelsHead(known.what, panels) }
                items(known.channels) { ChannelLine(it, known.channels.maxOf { each -> each.by(known.order) }, known.order) }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

/** Selects the range of the statistics. */
@Composable
private fun RangeChoice(panels: WindowPanels, view: AxisView, open: OpenRecording) {
    Row(Modifier.padding(start = 8.dp, end = 4.dp, top = 4.dp), Arrangement.spacedBy(2.dp)) {
        for (range in StatisticsRange.entries) {
            val (title, hint) = when (range) {
                StatisticsRange.SHOWN -> titleOfShown(view) to
                    "Statistics of the selection, or between both cursors, or else of the visible range"

                StatisticsRange.ENABLED -> "Enabled" to "Statistics of the enabled time"

                StatisticsRange.ALL -> "All" to "Statistics of the whole log"
            }
            val isKnown = range != StatisticsRange.ENABLED || open.enabled.isNotEmpty()
            ToolButton(hint, text = title, isOn = panels.state.statistics == range, isEnabled = isKnown) {
                panels.change { copy(statistics = range) }
            }
        }
    }
}

/** Returns a short title for [shownSpan]. */
internal fun titleOfShown(view: AxisView): String = when {
    view.selection != null -> "Selected"
    view.cursors.between != null -> "A–B"
    else -> "Visible"
}

/** The input of the statistics; while it stays equal, nothing is recalculated. */
internal data class StatisticsInput(
    val drawn: List<DrawnRecording>,
    val names: List<String>,
    val part: NamedSpan,
    val graphs: List<List<String>>,
    val order: ChannelOrder,
    val opened: String?,
)

/** Returns the current input for [part]; if that is null, for the displayed range. */
internal fun statisticsInput(
    compared: ComparedRecordings,
    board: GraphBoard,
    view: AxisView,
    part: NamedSpan? = null,
    order: ChannelOrder = ChannelOrder.CHARGE,
    opened: String? = null,
): StatisticsInput {
    val graphs = board.state.graphs.map { it.lines }
    val together = graphs.filter { it.size > 1 }.distinct()
    return StatisticsInput(compared.drawn, graphs.flatten().distinct(), part ?: shownSpan(view), together, order, opened)
}

private fun rangeText(statistics: RangeStatistics): String {
    val (from, to) = statistics.part.span
    val ends = "${numberText(from)} – ${withUnit(numberText(to), statistics.xUnit)}"
    return "${withUnit(numberText(statistics.part.width), statistics.xUnit)}  ($ends)"
}

@Composable
private fun SignalCells(signal: SignalStatistics, isOpen: Boolean, onToggle: () -> Unit) {
    val palette = LocalPalette.current
    Column(Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 10.dp)) {
        Row(verticalAlignment = Alignment.CenterVertically) {
            NameText(signal.signal, Modifier.weight(1f), fontWeight = FontWeight.SemiBold)
            // Neither states nor differences have one.
            if (signal.cells.any { it.name == Statistic.MEAN.title } && signal.cells.none { it.name == NamedDifference.TITLES.last() }) {
                ToolButton("Histogram of ${signal.signal}: ${Histogram.HINT}", Icons.Chart, isOn = isOpen, onClick = onToggle)
            }
        }
        if (signal.recording.isNotEmpty()) {
            Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
                Box(Modifier.size(8.dp).background(palette.colorOf(signal.place), RoundedCornerShape(2.dp)))
                NameText(signal.recording, color = palette.muted, fontSize = 12.sp)
            }
        }
        val (wide, narrow) = signal.cells.partition { it.isWide }
        for (pair in narrow.chunked(2)) {
            Row(Modifier.fillMaxWidth()) {
                for (cell in pair) Cell(cell, Modifier.weight(1f))
                if (pair.size == 1) Box(Modifier.weight(1f))
            }
        }
        for (cell in wide) Cell(cell, Modifier.fillMaxWidth(), nameWidth = WIDE_NAME)
        if (isOpen) HistogramPicture(signal)
    }
}

@Composable
private fun HistogramPicture(signal: SignalStatistics) {
    val histogram = signal.histogram ?: return Text(Histogram.NONE, color = LocalPalette.current.muted, fontSize = 12.sp)
    val colors = LocalPalette.current.pen
    Spacer(
        Modifier.fillMaxWidth().height(HISTOGRAM_HEIGHT.dp).semantics { contentDescription = "Histogram of ${signal.signal}" }.drawBehind {
            pen().drawHistogram(histogram, signal.unit, signal.place, size.width.toDouble(), colors)
        },
    )
}

@Composable
private fun Cell(cell: StatCell, modifier: Modifier, nameWidth: Int = NAME) {
    Row(modifier.padding(end = 4.dp)) {
        val muted = LocalPalette.current.muted
        NameText(cell.name, Modifier.width(nameWidth.dp), color = muted, fontSize = 12.sp, cut = NameCut.MIDDLE)
        // A number that is cut off would be a different one, so two lines are better.
        Tip(withUnit(cell.exact, cell.unit), Modifier.weight(1f)) {
            Text(withUnit(cell.text, cell.unit), fontSize = 12.sp, lineHeight = 15.sp)
        }
    }
}

private const val NAME = 66
private const val WIDE_NAME = 130
