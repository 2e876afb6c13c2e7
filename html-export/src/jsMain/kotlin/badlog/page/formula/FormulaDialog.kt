package badlog.page.formula

import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.plot.formula.Suggestions
import badlog.plot.formula.nameInExpression
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.events.KeyboardEvent

/**
 * Where a person adds formulas and takes them away.
 *
 * @param onAdd is called with a definition that has no mistake.
 * @param onRemove is called with one of the person's definitions.
 */
internal class FormulaDialog(private val formulas: Formulas, private val onAdd: (String) -> Unit, private val onRemove: (String) -> Unit) {
    private lateinit var input: HTMLInputElement
    private lateinit var suggestions: HTMLElement
    private lateinit var message: HTMLElement
    private lateinit var pointer: HTMLElement
    private lateinit var own: HTMLElement

    val element: HTMLElement = element("dialog", "help formula-dialog") {
        id = "formula-dialog"
        setAttribute("aria-label", "Add a formula")
        add("div", "help-head") {
            add("h2", "", "Add a formula")
            addIconButton("", Icon.CLOSE, "Close") { close() }
        }
        add("div", "formula-body") {
            add("p", "formula-hint", "A name, a unit in brackets if it has one, = and a calculation with topics, as in")
            add("code", "", "Power [W] = Battery Voltage * Total Current")
            add("div", "formula-entry") {
                input = add("input", "formula-input").unsafeCast<HTMLInputElement>()
                addButton("", "Add graph") { submit() }.id = "formula-add"
            }
            suggestions = add("div", "formula-suggestions")
            message = add("p", "formula-message")
            pointer = add("pre", "pointer")
            own = add("ul", "formula-list")
        }
        addEventListener("click", { if (it.target == this) close() })
    }

    init {
        input.id = "formula"
        input.autocomplete = "off"
        input.spellcheck = false
        input.setAttribute("aria-label", "Formula")
        input.setAttribute("aria-describedby", "formula-message")
        message.id = "formula-message"
        message.setAttribute("role", "status")
        input.addEventListener("input", { check(isFinal = false) })
        input.addEventListener("keydown", { event ->
            if (event.unsafeCast<KeyboardEvent>().key == "Enter") {
                // Else the button that has the focus once this is closed would be pressed as well.
                event.preventDefault()
                submit()
            }
        })
    }

    /** Shows it. */
    fun open() {
        if (element.hasAttribute("open")) return
        element.asDynamic().showModal()
        listOwn()
        check(isFinal = false)
        input.focus()
    }

    private fun close() {
        element.asDynamic().close()
    }

    private fun submit() {
        val text = input.value.trim()
        if (!check(isFinal = true)) return
        input.value = ""
        close()
        onAdd(text)
    }

    /** Tells what is wrong, quietly while the person may still be typing it, and whether nothing is. */
    private fun check(isFinal: Boolean): Boolean {
        // What spaces there are before it are not to move the mark.
        val text = input.value.trim()
        val mistake = if (text.isEmpty() && !isFinal) null else formulas.mistakeIn(text)
        message.showText(mistake?.message.orEmpty())
        pointer.showText(mistake?.pointed()?.substringAfter('\n').orEmpty())
        for (part in listOf(message, pointer)) part.isHidden = mistake == null
        message.classList.toggle("is-error", isFinal)
        // A long one does not fit, and its mistake mostly is at its end.
        pointer.scrollLeft = maxOf(0, (mistake?.from ?: 0) - LETTERS_BEFORE) * LETTER_WIDTH
        suggest()
        if (isFinal) input.focus()
        return mistake == null && text.isNotEmpty()
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
                add("code", "", definition)
                addIconButton("formula-remove", Icon.CLOSE, "Remove $definition") {
                    onRemove(definition)
                    listOwn()
                    input.focus()
                }
            }
        }
    }

    private companion object {
        const val LETTERS_BEFORE = 8
        const val LETTER_WIDTH = 7.2
    }
}
