package badlog.viewer.panel

import badlog.core.recording.Severity
import badlog.viewer.state.Action

/** A part of what a panel says and offers, as data: each shell draws each kind once. */
sealed interface Part {
    /** Identifies the part among those beside it, so that focus and scrolling stay; its first word says what the part is. */
    val key: String
}

/**
 * The title of a panel.
 *
 * @property status how much is in the panel, or what it waits for; screen readers say it when it changes.
 * @property tools what the panel offers.
 */
class Heading(val title: String, val status: String, val tools: List<Button> = emptyList()) : Part {
    override val key: String get() = "heading"
}

/** A paragraph of plain text, with [button] for what can be done about it; null for nothing. */
class Paragraph(override val key: String, val text: String, val tone: Tone = Tone.BODY, val button: Button? = null) : Part

/** How a text is meant. */
enum class Tone {
    /** What the panel is about. */
    BODY,

    /** What explains something else. */
    MUTED,

    /** What needs somebody. */
    ALERT,
}

/**
 * Something that is wrong.
 *
 * @property text what is wrong, where, and what to do.
 * @property pointer the place in a file, with carets below it; empty for none.
 */
class Trouble(override val key: String, val severity: Severity, val text: String, val pointer: String = "") : Part

/** Something to press. */
class Button(val label: String, val action: Action, val icon: PartIcon? = null, val hint: String = label, val isEnabled: Boolean = true)

/** The icons of buttons. */
enum class PartIcon { PREVIOUS, NEXT, AGAIN, PIN, ADD, REMOVE, DONE, PERSON, UNDONE }

/** Buttons beside each other. */
class Buttons(override val key: String, val buttons: List<Button>) : Part

/** Sentences to press, below each other in a box with a [title]. */
class Offers(override val key: String, val title: String, val buttons: List<Button>) : Part

/** One of several: a person chooses one of [options], the one with [Option.isOn] is chosen. */
class Choice(override val key: String, val name: String, val options: List<Option>) : Part

/** One of a [Choice], called [label]. */
class Option(val label: String, val isOn: Boolean, val action: Action)

/** Lines of a program, called [name] by screen readers. */
class Code(override val key: String, val name: String, val text: String) : Part

/** Parts that a press on [title] shows or hides; while it is not open, [parts] need not be known. */
class Fold(override val key: String, val title: String, val isOpen: Boolean, val toggle: Action, val parts: List<Part>) : Part

/**
 * A field that a person types into.
 *
 * @property label what it asks for.
 * @property hint what choosing or typing does.
 * @property text its text.
 * @property isSearch whether each letter counts; otherwise only what is chosen or confirmed.
 * @property suggestions what can be chosen.
 */
class Field(
    override val key: String,
    val label: String,
    val hint: String = label,
    val text: String = "",
    val isSearch: Boolean = false,
    val suggestions: List<String> = emptyList(),
    val onText: (String) -> Action,
) : Part

/** Rows below each other; [name] says what they are. */
class Rows(override val key: String, val name: String, val rows: List<Row>, val isLong: Boolean = false) : Part

/**
 * A row of a list: a claim, a note, an event.
 *
 * @property severity how serious it is; null where that does not matter.
 * @property name what a screen reader calls it.
 * @property title what it is, in a few words; empty if its lines say that.
 * @property lines what it says, each with its time.
 * @property count how often it was, if it was more than once; empty otherwise.
 * @property isFramed whether its lines belong together.
 * @property isCurrent whether it is what a person went to.
 * @property open what a press on it does; null for nothing.
 * @property tools what it offers.
 * @property menu what its context menu offers.
 * @property below what else is known of it.
 */
class Row(
    override val key: String,
    val severity: Severity?,
    val name: String,
    val title: String,
    val lines: List<Line>,
    val count: String = "",
    val isFramed: Boolean = false,
    val isCurrent: Boolean = false,
    val open: Action? = null,
    val tools: List<Button> = emptyList(),
    val menu: List<Button> = emptyList(),
    val below: List<Part> = emptyList(),
) : Part

/**
 * A sentence with its time.
 *
 * @property time when it was, or when it began; where it has no time, what it is about.
 * @property until when it ended; empty for a moment.
 * @property since the same on the robot's clock, from when it was first enabled; null where it is unknown.
 * @property name what a screen reader calls it, where it is not all of a row.
 * @property open what a press on it does; null for nothing.
 * @property hint what a press on it does, in words.
 * @property isCurrent whether it is what a person went to.
 */
class Line(
    val text: String,
    val time: String,
    val until: String = "",
    val since: String? = null,
    val name: String = "",
    val open: Action? = null,
    val hint: String = "",
    val isCurrent: Boolean = false,
)
