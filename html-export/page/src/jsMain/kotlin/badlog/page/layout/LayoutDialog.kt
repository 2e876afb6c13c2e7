package badlog.page.layout

import badlog.page.dom.Dialog
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addIconButton
import badlog.page.dom.addTextField
import badlog.page.view.Notice
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.keptLayoutAfter
import badlog.viewer.choices.board.noLayoutKept
import badlog.viewer.input.KeyAction
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.events.KeyboardEvent

/**
 * The dialog that stores the board under a name and shows stored boards. A key steps through them as well.
 *
 * @param layoutNow returns the layout to store.
 * @param onSwitch called with a layout to show, and its name.
 */
internal class LayoutDialog(
    private val kept: KeptLayouts,
    private val notice: Notice,
    private val layoutNow: () -> BoardLayout,
    private val onSwitch: (BoardLayout, String) -> Unit,
) {
    private lateinit var name: HTMLInputElement
    private lateinit var list: HTMLElement

    private val dialog = Dialog("layout-dialog", "topic-dialog", "Layouts") {
        add("div", "formula-body") {
            add("p", "unit", "This browser keeps them for all logs; ${KeyAction.NEXT_LAYOUT.shortcut} shows the next one.")
            list = add("ul", "topic-list")
            name = addTextField("formula-input", "layout-name", "Name of the layout", "Name, such as Power")
            addButton("", "Keep this board", "Keep this board (Enter)") { keep() }.id = "keep-layout"
        }
    }

    val element: HTMLElement = dialog.element

    init {
        name.maxLength = LONGEST
        name.addEventListener("keydown", {
            val key = it.unsafeCast<KeyboardEvent>()
            if (key.key == "Enter" && !key.isComposing) {
                // Otherwise the key would also press the button that opened the dialog, which gets the focus back.
                it.preventDefault()
                keep()
            }
        })
    }

    /** Opens the dialog with the stored layouts, and the name of the one shown last; does nothing if it is open. */
    fun open() {
        if (dialog.isOpen) return
        list()
        dialog.open()
        name.value = kept.shown.orEmpty()
        name.focus()
        // The reader can type another name at once, which stores another layout.
        name.select()
    }

    /** Shows the layout [steps] after the one shown last. */
    fun step(steps: Int) {
        val next = keptLayoutAfter(kept.names, kept.shown, steps)
        if (next == null) notice.say(noLayoutKept("keep the board as one with the button “Layouts” above it")) else switchTo(next)
    }

    private fun switchTo(name: String) {
        // Set even if the layout cannot be read, so that the key continues from there.
        kept.shown = name
        val layout = kept[name] ?: return notice.say("The layout “$name” can no longer be read; keep it again.")
        onSwitch(layout, name)
    }

    private fun keep() {
        val wanted = name.value.trim()
        if (wanted.isEmpty()) return name.focus()
        val isKept = kept.keep(wanted, layoutNow())
        notice.say(if (isKept) "Kept as “$wanted”." else "This browser does not let the page keep layouts; download it instead.")
        dialog.close()
    }

    private fun list() {
        list.textContent = ""
        for (each in kept.names) {
            list.add("li") {
                addButton("text-button", each) {
                    dialog.close()
                    switchTo(each)
                }.setAttribute("aria-pressed", (each == kept.shown).toString())
                addIconButton("", Icon.CLOSE, "Remove “$each”") {
                    kept.remove(each)
                    list()
                    name.focus()
                }
            }
        }
    }
}

private const val LONGEST = 60
