package badlog.viewer.state

import badlog.viewer.todo.TodoChange

/**
 * A dialog that asks a person for texts.
 *
 * @property fields the texts, at least one.
 * @property label the button that confirms it; it repeats the verb of [title].
 * @param answered returns the effects of the answers.
 */
class Form(val title: String, val fields: List<FormField>, val label: String, private val answered: (List<String>) -> List<Action>) {
    /** Returns whether [answers], one for each field, are complete. */
    fun isReady(answers: List<String>): Boolean = fields.indices.none { fields[it].isNeeded && answers[it].isBlank() }

    /** Returns the effects of [answers], which must be complete. */
    fun actions(answers: List<String>): List<Action> = answered(answers.map { it.trim() })

    companion object {
        /** The maximum number of characters in an answer. */
        const val MAX_TEXT: Int = TodoChange.MAX_TEXT
    }
}

/**
 * A field of a [Form].
 *
 * @property text the initial answer.
 * @property isNeeded whether the answer must not be empty.
 * @property suggestions texts to choose from.
 */
class FormField(val label: String, val text: String = "", val isNeeded: Boolean = false, val suggestions: List<String> = emptyList())
