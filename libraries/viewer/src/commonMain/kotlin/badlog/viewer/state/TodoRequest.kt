package badlog.viewer.state

import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoTask

/** A change of the team's list that only a shell can make. */
sealed interface TodoRequest : Request {
    /** Writes [deed], a change of [task]. */
    data class Write(val task: TodoTask, val deed: TodoDeed) : TodoRequest

    /** Asks the person how [item] was done. */
    data class AskDone(val item: TodoItem) : TodoRequest

    /** Asks who takes on [item]. */
    data class AskPerson(val item: TodoItem) : TodoRequest
}
