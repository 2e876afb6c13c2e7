package badlog.window.layout

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.FittedBoard
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.formula.nameIn
import badlog.window.log.OpenRecording

/**
 * Fits [board] to [recording]. A formula that fails there does not count as missing: the list of topics says why. Those of [definitions] that
 * are still to be calculated are not missing either.
 */
internal fun fitted(board: Board, recording: OpenRecording, definitions: List<String>): FittedBoard {
    val coming = (definitions - recording.definitions.toSet()).mapNotNullTo(HashSet(), ::nameIn)
    return board.fittedTo(excused = recording.formulas.mapNotNullTo(HashSet()) { it.name }) { recording.signal(it) != null || it in coming }
}

/** Returns [span] in the window's form; null if it is not valid. */
internal fun spanOf(span: LayoutSpan): Span? =
    if (span.from < span.to && span.from.isFinite() && span.to.isFinite()) Span(span.from, span.to) else null
