package badlog.viewer.panel

import badlog.viewer.state.Action
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Form
import badlog.viewer.state.FormField
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoItem
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoSubject
import badlog.viewer.todo.UNNAMED_MATCH
import badlog.viewer.todo.matchText

/** Asks how [item] was done; [author] is the person at this computer. */
internal fun TodoList.doneForm(item: TodoItem, author: String): Form {
    val fields = listOf(FormField("What was done"), FormField("Before which match", next), FormField("By whom", author))
    return Form("Mark as done: ${item.title}", fields, "Mark as done") { (what, before, by) ->
        listOf(write(item.task, TodoDeed.Done(what, matchText(before, lastMatch).ifEmpty { null }), by.ifEmpty { null }))
    }
}

/** Asks who takes on [item]. */
internal fun assignForm(item: TodoItem): Form = Form("Assign: ${item.title}", listOf(FormField(WHO, item.person)), "Assign") { (person) ->
    listOf(write(item.task, TodoDeed.Assign(person)))
}

/** Asks for a new item. */
internal fun newItemForm(): Form =
    Form("New item", listOf(FormField("What is to be done", isNeeded = true), FormField(WHO)), "Add") { (text, person) ->
        val task = OwnTask(text)
        listOf(write(task, TodoDeed.Open)) + if (person.isEmpty()) emptyList() else listOf(write(task, TodoDeed.Assign(person)))
    }

/** Asks which match is the next one. */
internal fun TodoList.nextMatchForm(): Form {
    val known = if (next.startsWith("the ") || next == UNNAMED_MATCH) "" else next
    val field = FormField("Next match, such as Qualification 61 or q61", known, isNeeded = true)
    return Form("Set the next match", listOf(field), "Set") { (match) ->
        listOf(write(NextMatch(matchText(match, lastMatch)), TodoDeed.Open))
    }
}

private fun write(subject: TodoSubject, deed: TodoDeed, by: String? = null) = Action.Ask(FolderRequest.WriteTodo(subject, deed, by))

private const val WHO = "Who takes it on; nobody if empty"
