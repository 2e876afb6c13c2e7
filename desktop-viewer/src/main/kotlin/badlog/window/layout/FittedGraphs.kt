package badlog.window.layout

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.FittedBoard
import badlog.viewer.choices.board.fittedTo
import badlog.window.log.OpenRecording

/** Fits [board] to [recording]. A formula that fails there does not count as missing: the list of topics says why. */
internal fun fitted(board: Board, recording: OpenRecording): FittedBoard =
    board.fittedTo(excused = recording.formulas.mapNotNullTo(HashSet()) { it.name }) { recording.signal(it) != null }

/** Returns [span] in the window's form; null if it is not valid. */
internal fun spanOf(span: LayoutSpan): Span? =
    if (span.from < span.to && span.from.isFinite() && span.to.isFinite()) Span(span.from, span.to) else null
