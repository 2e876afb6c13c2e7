package badlog.window.graph.mark

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.layout
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.draw.mark.markNear
import badlog.viewer.draw.plot.drawFindingMarks
import badlog.viewer.text.word
import badlog.window.findings.findingColor
import badlog.window.graph.plot.frameOf
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette
import badlog.window.theme.labelFrame

/** The text of the finding under the pointer, or otherwise at the pinned cursor, above its mark. */
@Composable
internal fun FindingLabel(scene: GraphScene, modifier: Modifier) {
    val shown by remember(scene) {
        derivedStateOf {
            scene.findings.state.pointed
                ?: scene.findings.selected?.takeIf { scene.view.isCursorPinned && isAt(it, scene.view.cursor) }
        }
    }
    val finding = shown ?: return
    val span by remember(scene, finding) { derivedStateOf { placeOf(finding, scene) } }
    val palette = LocalPalette.current
    Box(modifier.fillMaxWidth().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter, bottom = 2.dp)) {
        Column(
            Modifier
                .layout { measurable, constraints ->
                    val room = constraints.maxWidth
                    fun pixelOf(x: Double) = pixelOf(x, scene.view.viewport.visible, room.toFloat()).toInt()
                    val from = pixelOf(span.from)
                    val to = pixelOf(span.to)
                    val gap = GAP.dp.roundToPx()
                    val most = widthBeside(from, to, room, gap, MIN_WIDTH.dp.roundToPx(), MAX_WIDTH.dp.roundToPx())
                    val label = measurable.measure(constraints.copy(minWidth = 0, maxWidth = most))
                    layout(room, label.height) { label.place(besides(from, to, label.width, room, gap), 0) }
                }
                .labelFrame(palette.findingColor(finding.severity)),
        ) {
            // A person who opened an incident sees all of it, not only its first finding.
            val incident = scene.findings.state.list?.incidentOf(finding)?.takeIf {
                scene.findings.state.pointed == null &&
                    it.sentences[0].finding === finding && span.from == finding.time
            }
            Text(
                if (incident == null) "${finding.severity.word}: ${finding.rule}" else "${incident.severity.word}: ${incident.name}",
                color = palette.findingColor(incident?.severity ?: finding.severity),
                fontSize = 12.sp,
                fontWeight = FontWeight.SemiBold,
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
            val said = incident?.sentences?.map { it.text } ?: listOf(finding.textAt(span))
            for (text in said) Text(text.take(MAX_LETTERS), fontSize = 12.sp, maxLines = 4, overflow = TextOverflow.Ellipsis)
        }
    }
}

/**
 * Returns the width of a label that does not cover pixels [from] to [to] of [room]. It is the width of the wider side, but at most [most];
 * if that side is narrower than [least], it is [most].
 */
internal fun widthBeside(from: Int, to: Int, room: Int, gap: Int, least: Int, most: Int): Int {
    val wider = maxOf(minOf(from, room), room - maxOf(to, 0)) - gap
    return minOf(room, if (wider >= least) minOf(wider, most) else most)
}

/**
 * Returns the left edge of a label of [width] that does not cover pixels [from] to [to] of [room]. The label is to the right, or otherwise
 * to the left; if neither has room, on the side with more.
 */
internal fun besides(from: Int, to: Int, width: Int, room: Int, gap: Int): Int {
    val left = from - gap - width
    val right = to + gap
    val last = maxOf(0, room - width)
    return if (right <= last) {
        maxOf(0, right)
    } else if (left >= 0) {
        minOf(left, last)
    } else if (room - to > from) {
        last
    } else {
        0
    }
}

/** Returns the relevant place of [finding]: the one under the pointer, or the one at the cursor. */
private fun placeOf(finding: Finding, scene: GraphScene): Span {
    val state = scene.findings.state
    val at = (if (finding == state.pointed) state.pointedPlace.takeIf { it.isFinite() } else scene.view.cursor) ?: finding.time
    return finding.places.find { it.from == at } ?: Span(at, at)
}

private fun isAt(finding: Finding, cursor: Double?) = finding.time == cursor || finding.spans.any { it.from == cursor }

private const val MAX_WIDTH = 340

/** A narrower label would become too high. */
private const val MIN_WIDTH = 150
private const val GAP = 8
private const val MAX_LETTERS = 600

/** The text of the note or event near the pointer, or otherwise near the cursor. It is above the graphs, which stay visible. */
@Composable
internal fun EventLabel(scene: GraphScene) {
    val event by remember(scene) { derivedStateOf { scene.view.cursors.pointed?.let { saidAt(it, scene) } } }
    val shown = event ?: return
    val palette = LocalPalette.current
    BoxWithConstraints(Modifier.fillMaxWidth().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)) {
        Text(
            shown.text.take(MAX_EVENT_LETTERS),
            Modifier
                .layout { measurable, constraints ->
                    val label = measurable.measure(constraints.copy(minWidth = 0, maxWidth = constraints.maxWidth / 2))
                    layout(constraints.maxWidth, label.height) {
                        val x = pixelOf(shown.x, scene.view.viewport.visible, constraints.maxWidth.toFloat())
                        val beside = SIDE.dp.roundToPx()
                        // The label is on the other side if this one has too little room.
                        val left = if (x + beside + label.width <= constraints.maxWidth) x + beside else x - beside - label.width
                        label.place(left.toInt().coerceAtLeast(0), -label.height)
                    }
                }
                .labelFrame(palette.event),
            fontSize = 12.sp,
            maxLines = 2,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

private fun saidAt(cursor: Double, scene: GraphScene) =
    markNear(cursor, scene.view.viewport.visible, scene.notes.all, scene.events.matching)

private const val SIDE = 8
private const val MAX_EVENT_LETTERS = 400

/**
 * The marks of the findings on the time axis. The pointer on one shades its time and shows its text; a click goes there. The strip takes up
 * its space even without findings, because graphs that shrink later would be drawn twice.
 */
@Composable
internal fun FindingStrip(scene: GraphScene) {
    val palette = LocalPalette.current
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .semantics { contentDescription = "Findings on the time axis" }
                .findingPointer(scene)
                .drawBehind {
                    val frame = frameOf(scene.view.viewport.visible)
                    scene.findings.state.list?.let { pen().drawFindingMarks(frame, it.timeline, palette.pen) }
                },
        )
    }
}

private fun Modifier.findingPointer(scene: GraphScene): Modifier = pointerInput(scene) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent()
            val visible = scene.view.viewport.visible
            val change = event.changes.first()
            val x = visible.from + change.position.x / size.width * visible.width
            val reach = REACH * density / size.width * visible.width
            val found = scene.findings.state.list?.timeline?.pointedAt(x, reach, visible)
            val place = if (found == null) Double.NaN else found.placeNear(x)?.from ?: found.time
            when (event.type) {
                PointerEventType.Enter, PointerEventType.Move -> scene.findings.point(found, place)
                PointerEventType.Exit -> scene.findings.point(null)
                PointerEventType.Release -> if (found != null) scene.findings.goTo(found, place)
                else -> Unit
            }
        }
    }
}

private const val HEIGHT = 14
private const val REACH = 6
