package badlog.viewer.state

import badlog.viewer.input.KeyAction

/** An action of a person, a file or a clock: the only thing that changes a [ViewerState]. */
sealed interface Action {
    /** A person presses [key], or a button that does the same. */
    class Press(val key: KeyAction) : Action

    /** Unfolds the part of a panel with the key [fold], or folds it. */
    class Unfold(val fold: String, val isOpen: Boolean) : Action

    /** Chooses the range of [statistics], and the order of channels. */
    class Measure(val statistics: StatisticsState) : Action

    /** Asks for a [Request], which only the shell can perform. */
    data class Ask(val request: Request) : Action
}
