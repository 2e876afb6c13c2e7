package badlog.viewer.state

import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.EvidenceOffer
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.battery.BatteryMatch
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject
import badlog.viewer.choices.note.Note as LogNote

/**
 * A task that only a shell can perform. The shells' `when` has no `else`, so that a new task does not compile until page and window both
 * perform it.
 */
sealed interface Request {
    /** Opens the values at the cursor, or closes them. */
    object Values : Request

    /** Opens the modules of a swerve drive at the cursor, or closes them. For a log without modules, says so. */
    object Modules : Request

    /** Adds the graph that keys apply to, or removes it: it need not be one of the board's. */
    object Pin : Request

    /**
     * Remembers the board, and shows which graphs are new if they are out of sight.
     *
     * @property before the graphs that were drawn before the change; null if nothing has changed.
     * @property moved the graph that a key has moved, which is shown, too; null for none.
     */
    data class Graphs(val before: Board?, val moved: Int? = null) : Request

    /** Shows the graphs of the kept layout that is [steps] after the one shown, see [keptLayoutAfter][badlog.viewer.choices.board.keptLayoutAfter]. */
    class Layout(val steps: Int) : Request

    /** Announces the place to which the keys have moved a cursor. */
    object Cursor : Request

    /** Copies [text]. */
    class Copy(val text: () -> String) : Request

    /** Asks for a formula. */
    object Formula : Request

    /** Asks for the text of a note at [x]. */
    data class Note(val x: Double) : Request

    /** Asks for a new text for [note]. */
    class ChangeNote(val note: LogNote) : Request

    /** Removes [note], and offers to restore it. */
    class RemoveNote(val note: LogNote) : Request

    /** Adds a mark at [x], a note that needs no text. */
    data class Mark(val x: Double) : Request

    /** Shows the frame of the video that is [count] further, or back if negative, and moves the cursor there. */
    class Frames(val count: Int) : Request
}

/** A task about the findings of a log that only a shell can perform. */
sealed interface FindingRequest : Request {
    /**
     * Shows the evidence of a finding to which a person goes.
     *
     * @property place the place of the finding.
     * @property incident the incident that the finding is part of; null for none.
     * @property isWhole whether the person means all of [incident].
     * @property spoken the announcement of a screen reader after a key; null after a click.
     */
    data class Show(val place: FindingPlace<Finding>, val incident: Incident?, val isWhole: Boolean, val spoken: String? = null) :
        FindingRequest

    /** Announces that there is no finding to go to, or that the rules are still running. */
    object AnnounceNone : FindingRequest

    /** Adds the graphs that show [finding], and [incident] if it is part of one, to the board. */
    class Pin(val finding: Finding, val incident: Incident?) : FindingRequest

    /** Keeps the graphs that are shown for a finding on the board. */
    object Keep : FindingRequest

    /** Shows the graphs of [offer] beside the selected finding's graphs. */
    class Add(val offer: EvidenceOffer) : FindingRequest

    /** Shows the graph of [difference] over the last earlier match that has the compared number. */
    class Compare(val difference: Finding) : FindingRequest

    /** Runs the rules again. */
    object RunRules : FindingRequest

    /** Makes [topic] the signal [signal], and runs the rules again; if it cannot be that, [FindingAction.Refuse] says why. */
    class Assign(val signal: String, val topic: String) : FindingRequest

    /** Takes back the topic assigned to [signal], and runs the rules again. */
    class Forget(val signal: String) : FindingRequest

    /** Saves the signals that a person assigned as a file. */
    object SaveSignals : FindingRequest
}

/** A task for a folder of logs; none of them need be open. */
sealed interface FolderRequest : Request {
    /** Shows [form]. */
    class Fill(val form: Form) : FolderRequest

    /** Shows the team's batteries. */
    object Batteries : FolderRequest

    /** Shows the team's list. */
    object Todo : FolderRequest

    /** Asks for a file, and writes the team's list to it as a page. */
    object SaveTodo : FolderRequest

    /** Records that the robot had [battery] in [match]; an empty name removes the record. */
    data class UseBattery(val match: BatteryMatch, val battery: String) : FolderRequest

    /**
     * Writes [deed], a change of [subject], into the team's list.
     *
     * @property by the person who did it; null for the person at this computer.
     */
    data class WriteTodo(val subject: TodoSubject, val deed: TodoDeed, val by: String? = null) : FolderRequest
}

/** A task that concerns the logs compared with the open one; each has its index among them. */
sealed interface CompareRequest : Request {
    /** Lets the person choose a log to compare. */
    object Choose : CompareRequest

    /** Stops comparing. */
    object Clear : CompareRequest

    /** Aligns all logs by [alignment]. */
    class Align(val alignment: Alignment) : CompareRequest

    /** Moves [log] to [offset], in units of x. */
    class Move(val log: Int, val offset: Double) : CompareRequest

    /** Stops comparing with [log]. */
    class Remove(val log: Int) : CompareRequest
}
