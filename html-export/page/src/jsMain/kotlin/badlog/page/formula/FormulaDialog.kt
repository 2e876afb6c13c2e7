package badlog.page.formula

import badlog.page.dom.Dialog
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.addTextField
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.viewer.choices.formula.Suggestions
import badlog.viewer.choices.formula.nameInExpression
import badlog.viewer.choices.formula.reasonToKeep
import badlog.viewer.choices.formula.reasonToKeepName
import badlog.viewer.choices.formula.whileTyping
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.events.KeyboardEvent

/**
 * The dialog that adds, changes and removes formulas.
 *
 * @param onAdd called with a valid definition.
 * @param onChange called with one of the reader's definitions, and its replacement.
 * @param onRemove called with one of the reader's definitions that no other definition uses.
 */
internal class FormulaDialog(
    private val formulas: Formulas,
    private val onAdd: (String) -> Unit,
    private val onChange: (from: String, to: String) -> Unit,
    private val onRemove: (String) -> Unit,
) {
    private lateinit var input: HTMLInputElement
    private lateinit var suggestions: HTMLElement
    private lateinit var message: HTMLElement
    private lateinit var pointer: HTMLElement
    private lateinit var own: HTMLElement
    private lateinit var submitButton: HTMLElement

    /** The definition that is being changed; null while a new one is added. */
    private var changed: String? = null

    private val dialog = Dialog("formula-dialog", "formula-dialog") {
        add("div", "formula-body") {
            add("p", "formula-hint", "A name, a unit in brackets if it has one, = and a calculation with topics, as in")
            add("code", "", "Power [W] = Battery Voltage * Total Current")
            add("div", "formula-entry") {
                input = addTextField("formula-input", "formula", "Formula")
                submitButton = addButton("", "Add graph") { submit() }.apply { id = "formula-add" }
            }
            suggestions = add("div", "formula-suggestions")
            message = add("p", "formula-message")
            pointer = add("pre", "pointer")
            own = add("ul", "formula-list")
        }
    }

    val element: HTMLElement = dialog.element

    init {
        input.setAttribute("aria-describedby", "formula-message")
        message.id = "formula-message"
        message.setAttribute("role", "status")
        input.addEventListener("input", { check(isFinal = false) })
        input.addEventListener("keydown", { event ->
            if (event.unsafeCast<KeyboardEvent>().key == "Enter") {
                // Otherwise the key would also press the button that has the focus after closing.
                event.preventDefault()
                submit()
            }
        })
    }

    /** Opens the dialog for a new formula, with the list of the reader's own; does nothing if it is open. */
    fun open() {
        if (dialog.isOpen) return
        dialog.open()
        listOwn()
        edit(null)
    }

    private fun edit(definition: String?) {
        if (definition != null) {
            input.value = definition
        } else if (changed != null) {
            input.value = ""
        }
        changed = definition
        dialog.title = if (definition == null) "New formula" else "Change the formula"
        submitButton.textContent = if (definition == null) "Add graph" else "Change graph"
        check(isFinal = false)
        input.focus()
    }

    private fun submit() {
        val text = input.value.trim()
        if (!check(isFinal = true)) return
        val replaced = changed
        input.value = ""
        changed = null
        dialog.close()
        if (replaced == null) onAdd(text) else onChange(replaced, text)
    }

    /** Shows the mistake, unobtrusively while the reader may still be typing. Returns whether there is none. */
    private fun check(isFinal: Boolean): Boolean {
        // Leading spaces must not move the mark.
        val text = input.value.trim()
        val mistake = if (text.isEmpty() && !isFinal) null else formulas.mistakeIn(text, changed)
        val reason =
            (if (isFinal) mistake?.message else mistake?.whileTyping()?.text) ?: changed?.let { formulas.all.reasonToKeepName(it, text) }
        show(reason.orEmpty(), isFinal)
        pointer.showText(mistake?.pointed()?.substringAfter('\n').orEmpty())
        pointer.isHidden = mistake == null || reason != mistake.message
        // A long formula does not fit, and its mistake is usually near its end.
        pointer.scrollLeft = maxOf(0, (mistake?.from ?: 0) - LETTERS_BEFORE) * LETTER_WIDTH
        suggest()
        if (isFinal) input.focus()
        return reason == null && text.isNotEmpty()
    }

    private fun show(text: String, isError: Boolean) {
        message.showText(text)
        message.isHidden = text.isEmpty()
        message.classList.toggle("is-error", isError)
    }

    private fun suggest() {
        val caret = input.selectionStart ?: input.value.length
        val found = Suggestions.of(input.value, caret, formulas.vocabulary)
        suggestions.textContent = ""
        suggestions.isHidden = found.names.isEmpty()
        for (name in found.names.map { nameInExpression(it, formulas.vocabulary) }) {
            suggestions.addButton("", name, "Insert this topic") {
                input.asDynamic().setRangeText(name, found.from, found.until, "end")
                input.focus()
                check(isFinal = false)
            }
        }
    }

    private fun listOwn() {
        own.textContent = ""
        own.isHidden = formulas.own.isEmpty()
        for (definition in formulas.own) {
            own.add("li") {
                addButton("text-button", "", "Change this formula") { edit(definition) }.add("code", "", definition)
                addIconButton("formula-remove", Icon.CLOSE, "Remove $definition") { remove(definition) }
            }
        }
    }

    private fun remove(definition: String) {
        formulas.all.reasonToKeep(definition)?.let { return show(it, isError = true) }
        onRemove(definition)
        listOwn()
        if (changed == definition) edit(null) else input.focus()
    }
}

private const val LETTERS_BEFORE = 8
private const val LETTER_WIDTH = 7.2
