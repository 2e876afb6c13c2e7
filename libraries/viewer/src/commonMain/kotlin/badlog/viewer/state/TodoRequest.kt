package badlog.viewer.state

import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoTask

/** What only a shell can do with a team's list. */
sealed interface TodoRequest : Request {
    /** Writes that [deed] was done to [task]. */
    data class Write(val task: TodoTask, val deed: TodoDeed) : TodoRequest

    /** Asks how [item] was done. */
    data class AskDone(val item: TodoItem) : TodoRequest

    /** Asks who takes [item] on. */
    data class AskPerson(val item: TodoItem) : TodoRequest
}
