package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import badlog.viewer.panel.Button
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Tone
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Form
import badlog.viewer.todo.Check
import badlog.viewer.todo.FaultTask
import badlog.viewer.todo.FoundFault
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.OwnTask
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.TodoSubject
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class TodoPanelSpec : FunSpec({
    val brownout = FaultTask("Browned out", null)
    val fault = FoundFault(brownout, Severity.ERROR, "The battery fell to 6.1 V.")
    val log = TodoLog("q57.bag", MatchOfLog("Mill Creek", "Qualification", "57"), 1_000_000, listOf(fault))

    fun change(second: Int, subject: TodoSubject, deed: TodoDeed) = TodoChange("id$second", "2026-03-07T14:00:$second.000Z", "Ada", subject, deed, log.second - 60)
    val radio = change(10, OwnTask("Check the radio"), TodoDeed.Open)

    fun todo(vararg changes: TodoChange, logs: List<TodoLog> = listOf(log), hasFolder: Boolean = true) = TodoList.of(changes.toList(), logs).let { ListedTodo(it, it.checklist(listOf("Bumpers are tight")), hasFolder, hasOwnLines = false, "Ada") }

    fun panel(todo: ListedTodo, isDoneOpen: Boolean = false) = todoPanel(todo, mapOf("todo-done" to isDoneOpen)) { "/logs/$it" }
    fun List<Part>.rows(key: String) = filterIsInstance<Rows>().single { it.key == key }.rows.map { it as Row }
    fun Action?.form(): Form = shouldBeInstanceOf<Action.Ask>().request.shouldBeInstanceOf<FolderRequest.Fill>().form
    fun write(subject: TodoSubject, deed: TodoDeed, by: String? = null) = Action.Ask(FolderRequest.WriteTodo(subject, deed, by))
    fun Row.tool(label: String) = tools.single { it.label == label }.action

    test("an open item has its severity, its details, a box to mark it as done, and opens the log in which it was found") {
        val item = panel(todo()).rows("open").single()
        item.severity shouldBe Severity.ERROR
        item.title shouldBe "Browned out"
        item.below.map { (it as Paragraph).text } shouldBe listOf("The battery fell to 6.1 V.", "Found in Qualification 57.")
        item.open.shouldBeInstanceOf<FolderAction.Open>().run { path to showsFinding } shouldBe ("/logs/q57.bag" to true)
        item.check?.run { label to isOn } shouldBe ("Mark as done: Browned out" to false)
        item.tools.map(Button::hint) shouldBe listOf("Assign…: Browned out", "Take off the list: Browned out")
        item.tool("Take off the list") shouldBe write(brownout, TodoDeed.Remove)
    }

    test("an item that came back says so first, and one of a person names the person") {
        val again = panel(todo(change(10, brownout, TodoDeed.Done("new lead", "Qualification 57")), change(11, brownout, TodoDeed.Assign("Ben"))))
        val lines = again.rows("open").single().below.map { it as Paragraph }
        lines.take(2).map { it.text to it.tone } shouldBe
            listOf("To do: Ben" to Tone.BODY, "Again, after it was done before Qualification 57." to Tone.ALERT)
    }

    test("marking an item as done asks how, before which match and by whom") {
        val form = panel(todo()).rows("open").single().check?.action.form()
        form.title shouldBe "Mark as done: Browned out"
        form.fields.map { it.label to it.text } shouldBe
            listOf("What was done" to "", "Before which match" to "the match after Qualification 57", "By whom" to "Ada")
        form.actions(listOf(" new breaker ", "q58", "Ben")) shouldBe listOf(write(brownout, TodoDeed.Done("new breaker", "Qualification 58"), "Ben"))
        form.actions(listOf("", "", "")) shouldBe listOf(write(brownout, TodoDeed.Done("", null)))
    }

    test("an item is assigned to a person, or to nobody") {
        val form = panel(todo(radio, logs = emptyList())).rows("open").single().tool("Assign…").form()
        form.actions(listOf("Ben")) shouldBe listOf(write(OwnTask("Check the radio"), TodoDeed.Assign("Ben")))
        form.isReady(listOf("")) shouldBe true
    }

    test("a new item needs a text, and may have a person at once") {
        val form = (panel(todo()).first() as Heading).tools.first().action.form()
        form.isReady(listOf(" ", "Ben")) shouldBe false
        val task = OwnTask("Check the radio")
        form.actions(listOf("Check the radio", "")) shouldBe listOf(write(task, TodoDeed.Open))
        form.actions(listOf("Check the radio", "Ben")) shouldBe listOf(write(task, TodoDeed.Open), write(task, TodoDeed.Assign("Ben")))
    }

    test("the checklist is of the next match, which a person names") {
        val parts = panel(todo())
        val title = parts.filterIsInstance<Paragraph>().first()
        title.text shouldBe "Checklist before the match after Qualification 57"
        title.button?.action.form().actions(listOf("q61")) shouldBe listOf(write(NextMatch("Qualification 61"), TodoDeed.Open))
        parts.rows("checks").single().check?.run { listOf(label, "$isOn") } shouldBe listOf("Check: Bumpers are tight", "false")
        val line = Check("Bumpers are tight", "the match after Qualification 57")
        parts.rows("checks").single().open shouldBe write(line, TodoDeed.Done())
        val ticked = panel(todo(change(10, line, TodoDeed.Done()))).rows("checks").single()
        ticked.run { (below.single() as Paragraph).text to open } shouldBe ("Ada" to write(line, TodoDeed.Open))
    }

    test("done items are folded, and can be taken back") {
        val done = todo(change(10, OwnTask("Check the radio"), TodoDeed.Done("new radio")), logs = emptyList())
        panel(done).last().shouldBeInstanceOf<Fold>().run { listOf(title, "$isOpen", "${parts.size}") } shouldBe listOf("Done: 1", "false", "0")
        val row = (panel(done, isDoneOpen = true).last() as Fold).parts.rows("done").single()
        (row.below.single() as Paragraph).text shouldBe "Done by Ada: new radio"
        row.check?.run { isOn to action } shouldBe (true to write(OwnTask("Check the radio"), TodoDeed.Open))
    }

    test("an empty list says where items come from, and without a folder that one is needed") {
        fun first(hasFolder: Boolean) = panel(todo(logs = emptyList(), hasFolder = hasFolder))
        (first(hasFolder = true)[1] as Paragraph).text.substringBefore('.') shouldBe "Nothing is open"
        first(hasFolder = false).run { (last() as Paragraph).text to (first() as Heading).tools.any { it.isEnabled } } shouldBe
            ("Open a folder of logs; its list is kept beside them." to false)
    }

    test("the pit sees the first items and the progress of the checklist") {
        val many = (10..15).map { change(it, OwnTask("Task $it"), TodoDeed.Open) }
        val card = pitTodo(todo(*many.toTypedArray()))
        card?.title shouldBe "To do"
        card?.lines shouldBe listOf("• Browned out", "• Task 10", "• Task 11", "• Task 12", "and 3 more", "Checklist: 0 of 1")
        pitTodo(todo(logs = emptyList()))?.title shouldBe "Nothing is open"
        pitTodo(todo(hasFolder = false)) shouldBe null
    }
})
