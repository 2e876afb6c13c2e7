package badlog.viewer.state

import badlog.viewer.shown.battery.BatteryMatch
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject

/** A task for a folder of logs; none of them need be open. */
sealed interface FolderRequest : Request {
    /** Shows [form]. */
    class Fill(val form: Form) : FolderRequest

    /** Shows the team's batteries. */
    object Batteries : FolderRequest

    /** Shows the team's list. */
    object Todo : FolderRequest

    /** Copies the team's list as Markdown. */
    object CopyTodo : FolderRequest

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
