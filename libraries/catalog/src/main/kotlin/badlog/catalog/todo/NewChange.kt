package badlog.catalog.todo

import badlog.viewer.choices.changeTime
import badlog.viewer.todo.FoundLog
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject
import java.util.UUID

/**
 * Returns the change that [author] makes to [subject] now.
 *
 * @param last the log of the folder that began last; null if there is none.
 * @param before the newest change that is known, see [changeTime]; null if there is none.
 */
fun newChange(subject: TodoSubject, deed: TodoDeed, author: String, last: FoundLog?, before: TodoChange? = null): TodoChange {
    val id = UUID.randomUUID().toString()
    return TodoChange(
        id,
        changeTime(before?.time),
        author.trim().take(TodoChange.MAX_TEXT),
        subject,
        deed,
        last?.second,
        last?.match?.event,
    )
}
