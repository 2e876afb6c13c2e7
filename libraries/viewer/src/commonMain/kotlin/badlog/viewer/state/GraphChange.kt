package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.dropped

/** A change of the drawn graphs, see [Board]; undoing restores the previous ones. */
sealed interface GraphChange : BoardAction {
    /** Adds a graph of [lines] at the end, or before the graph [before]. */
    class Add(val lines: List<String>, val before: Int? = null) : GraphChange

    /** Adds a graph for each of [lines]. */
    class AddEach(val lines: List<String>) : GraphChange

    /** Adds [graphs] at the end, or before the graph [before]. */
    class AddAll(val graphs: List<BoardGraph>, val before: Int? = null) : GraphChange

    /** Adds [lines] to graph [id], except lines that are already there. */
    class AddLines(val id: Int, val lines: List<String>) : GraphChange

    /** Adds [lines] to the last graph, or to a new one if there is none. */
    class AddToLast(val lines: List<String>) : GraphChange

    /** Adds [line] to graph [id], or removes it from there. */
    class ToggleLine(val id: Int, val line: String) : GraphChange

    /** Removes [line] from graph [id]; a graph without lines is removed. */
    class RemoveLine(val id: Int, val line: String) : GraphChange

    /** Hides [lines] of graph [id], or shows them again. */
    class HideLines(val id: Int, val lines: Collection<String>, val isHidden: Boolean) : GraphChange

    /** Adds [graph], or removes those that draw the same. */
    class Toggle(val graph: BoardGraph) : GraphChange

    /** Adds a graph of [line], drawn as [lines]; or removes each graph of these lines or of [line] alone. */
    class ToggleOwn(val line: String, val lines: List<String> = listOf(line)) : GraphChange

    /** Shows only [graphs]. */
    class ShowOnly(val graphs: List<BoardGraph>) : GraphChange

    /** Shows only a graph of [lines]; nothing changes if there are none. */
    class ShowOnlyLines(val lines: List<String>) : GraphChange

    /** Replaces the graph that has the id of [graph]. */
    class Replace(val graph: BoardGraph) : GraphChange

    /** Removes graph [id]. */
    class Remove(val id: Int) : GraphChange

    /** Moves graph [id] by [places], up if negative. */
    class Move(val id: Int, val places: Int) : GraphChange

    /** Moves graph [id] before the graph [other], or to the end for null. */
    class MoveBefore(val id: Int, val other: Int?) : GraphChange

    /** Drops graph [id] on the graph [onto], [share] below its top, see [dropped]. */
    class Drop(val id: Int, val onto: Int, val share: Double) : GraphChange

    /** Moves the lines of graph [other] to graph [id], and removes [other]. */
    class Join(val id: Int, val other: Int) : GraphChange

    /** Splits graph [id] into one graph for each line. */
    class Separate(val id: Int) : GraphChange

    /** Sets the height of graph [id], see [BoardGraph.height]. */
    class Resize(val id: Int, val height: Int?) : GraphChange

    /** Shows only [range] of y in graph [id], and [right] on its right axis; null for all of it. */
    class ShowY(val id: Int, val range: Span?, val right: Span? = null) : GraphChange

    /** Makes graph [id] share its y range with the others that do, or stops sharing. */
    class ShareY(val id: Int, val shares: Boolean) : GraphChange

    /** Draws the lines of graph [id] over each other, or over the x axis again. */
    class DrawXy(val id: Int, val isXy: Boolean) : GraphChange

    /** Draws the first line of graph [id] over the second instead. */
    class SwapAxes(val id: Int) : GraphChange

    /** Shows only the ranges [x] and [y] in graph [id], a graph of y over x; null shows all of it. */
    class ShowPlane(val id: Int, val x: Span?, val y: Span?) : GraphChange

    /** Treats the poses of graph [id] as measured from [origin]. */
    class MeasureFrom(val id: Int, val origin: FieldOrigin) : GraphChange
}

/** Returns the graphs after [change]. */
internal fun Board.after(change: GraphChange): Board = when (change) {
    is GraphChange.Add -> withGraph(change.lines, change.before)
    is GraphChange.AddEach -> change.lines.fold(this) { board, line -> board.withGraph(listOf(line)) }
    is GraphChange.AddAll -> withGraphs(change.graphs, change.before)
    is GraphChange.AddLines -> withLines(change.id, change.lines)
    is GraphChange.AddToLast -> withLinesInLast(change.lines)
    is GraphChange.ToggleLine -> change.run { if (isDrawn(id, line)) withoutLine(id, line) else withLine(id, line) }
    is GraphChange.RemoveLine -> withoutLine(change.id, change.line)
    is GraphChange.HideLines -> change.lines.fold(this) { board, line -> board.withLineHidden(change.id, line, change.isHidden) }
    is GraphChange.Toggle -> withToggled(change.graph)
    is GraphChange.ToggleOwn -> withOwnToggled(change.line, change.lines)
    is GraphChange.ShowOnly -> Board(change.graphs)
    is GraphChange.ShowOnlyLines -> if (change.lines.isEmpty()) this else Board().withGraph(change.lines)
    is GraphChange.Replace -> with(change.graph)
    is GraphChange.Remove -> without(change.id)
    is GraphChange.Move -> moved(change.id, change.places)
    is GraphChange.MoveBefore -> movedBefore(change.id, change.other)
    is GraphChange.Drop -> dropped(change.id, change.onto, change.share)
    is GraphChange.Join -> joined(change.id, change.other)
    is GraphChange.Separate -> separated(change.id)
    is GraphChange.Resize -> resized(change.id, change.height)
    is GraphChange.ShowY -> withYRange(change.id, change.range, change.right)
    is GraphChange.ShareY -> withSharedY(change.id, change.shares)
    is GraphChange.DrawXy -> withXy(change.id, change.isXy)
    is GraphChange.SwapAxes -> withSwappedAxes(change.id)
    is GraphChange.ShowPlane -> withPlane(change.id, change.x, change.y)
    is GraphChange.MeasureFrom -> withOrigin(change.id, change.origin)
}

private fun Board.isDrawn(id: Int, line: String) = graphs.any { it.id == id && line in it.lines }
