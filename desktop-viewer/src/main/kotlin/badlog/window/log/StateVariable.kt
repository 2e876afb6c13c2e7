package badlog.window.log

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.state.Place
import badlog.viewer.state.StateCell
import badlog.viewer.state.ViewerState
import kotlin.random.Random

/** The state of the open log. A drawing that reads a part of it through `derivedStateOf` is redrawn when that part changes. */
internal class StateVariable : StateCell {
    // Random, so that other windows do not give their graphs the same ids.
    override var state: ViewerState by mutableStateOf(
        ViewerState(Place(Viewport(Span(0.0, 1.0))), BoardHistory { Random.nextInt(Int.MAX_VALUE) }),
    )
}
