package badlog.viewer.state

import badlog.viewer.input.KeyAction

/** What a person, a file or a clock causes: the only thing that changes a [ViewerState]. */
sealed interface Action {
    /** A person presses [key], or a button that does the same. */
    data class Press(val key: KeyAction) : Action

    /** A person asks for what only the shell can do. */
    data class Ask(val request: Request) : Action
}
