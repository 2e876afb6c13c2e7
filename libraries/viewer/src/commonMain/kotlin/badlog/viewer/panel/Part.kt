package badlog.viewer.panel

import badlog.core.recording.Severity
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen
import badlog.viewer.state.Action
import badlog.viewer.text.word

/** A part of a panel's content, as data. Each shell has one way to draw each kind. */
sealed interface Part {
    /** The identity of the part among its siblings, by which focus and scroll position are kept. Its first word is the kind of the part. */
    val key: String
}

/**
 * The title of a panel.
 *
 * @property status the amount of content, or the reason for waiting; screen readers say it when it changes.
 * @property tools the panel's buttons.
 */
class Heading(val title: String, val status: String, val tools: List<Button> = emptyList()) : Part {
    override val key: String get() = "heading"
}

/** A paragraph of plain text, with a [button] for its action; null for none. */
class Paragraph(override val key: String, val text: String, val tone: Tone = Tone.BODY, val button: Button? = null) : Part

/** The role of a text. */
enum class Tone {
    /** The text is the panel's subject. */
    BODY,

    /** The text explains something else. */
    MUTED,

    /** The text needs a person's attention. */
    ALERT,

    /** The text is the title of what follows, in large letters. */
    TITLE,
}

/**
 * A mistake or problem.
 *
 * @property text the problem and the next step.
 * @property pointer the place in a file, with carets below it; empty for none.
 * @property place the place in words; empty for none.
 * @property word the displayed word for [severity].
 */
class Trouble(
    override val key: String,
    val severity: Severity,
    val text: String,
    val pointer: String = "",
    val place: String = "",
    val word: String = severity.word,
) : Part

/** A button with its [action]. [isOn] is null unless it stands for something that can be on. */
class Button(
    val label: String,
    val action: Action,
    val icon: PartIcon? = null,
    val hint: String = label,
    val isEnabled: Boolean = true,
    val isOn: Boolean? = null,
)

/** The icons of buttons. */
enum class PartIcon { PREVIOUS, NEXT, AGAIN, PIN, ADD, REMOVE, NOTE, ZOOM, CLOSE, COPY, DONE, PERSON, UNDONE, HISTOGRAM }

/** Buttons beside each other. */
class Buttons(override val key: String, val buttons: List<Button>) : Part

/** Buttons with sentences, below each other in a box with a [title]. */
class Offers(override val key: String, val title: String, val buttons: List<Button>) : Part

/** A choice of one of [options]; the one with [Button.isOn] is chosen. */
class Choice(override val key: String, val name: String, val options: List<Button>) : Part

/** Lines of a program, called [name] by screen readers. */
class Code(override val key: String, val name: String, val text: String) : Part

/**
 * Parts that a press on their [title] shows or hides.
 *
 * @property parts the parts; they need not be known while they are hidden.
 * @property severity the worst severity of the parts; null if it does not matter.
 */
class Fold(override val key: String, val title: String, val isOpen: Boolean, val parts: List<Part>, val severity: Severity? = null) :
    Part {
    /** The effect of a press on [title]. */
    val toggle: Action get() = Action.Unfold(key, !isOpen)
}

/**
 * A field that a person types into.
 *
 * @property label the name of the requested text.
 * @property hint the effect of choosing or typing.
 * @property text its text.
 * @property isSearch whether each typed letter has an effect; otherwise only a chosen or confirmed text has one.
 * @property suggestions the texts to choose from.
 * @property isValid returns whether a text has an effect.
 */
class Field(
    override val key: String,
    val label: String,
    val hint: String = label,
    val text: String = "",
    val isSearch: Boolean = false,
    val suggestions: List<String> = emptyList(),
    val isValid: (String) -> Boolean = { true },
    val onText: (String) -> Action,
) : Part

/**
 * A named value.
 *
 * @property isMarked whether it has just changed.
 * @property tools its buttons.
 * @property color the index of the color of its lines; null for none.
 * @property field the field with its text; null if it cannot be typed.
 * @property maxLines the largest number of lines of its text.
 * @property exact returns the value to the last digit; called only when a person asks for it.
 */
class Value(
    override val key: String,
    val name: String,
    val text: String,
    val isMarked: Boolean = false,
    val tools: List<Button> = emptyList(),
    val color: Int? = null,
    val field: Field? = null,
    val maxLines: Int = 1,
    val exact: () -> String = { text },
) : Part

/**
 * Rows below each other, called [name]: each is a [Row], a [Value], a [Trouble] or a [Paragraph].
 *
 * @property rows the rows; a list may make each only when it is drawn.
 * @property isLong whether they scroll in a place of their own.
 * @property current the index of the row that a person went to; -1 for none.
 */
class Rows(
    override val key: String,
    val name: String,
    val rows: List<Part>,
    val isLong: Boolean = false,
    val current: Int = rows.indexOfFirst { (it as? Row)?.isCurrent == true },
) : Part

/**
 * A row of a list: a claim, a note, an event.
 *
 * @property severity its severity; null if that does not matter.
 * @property name its name for screen readers.
 * @property title its title, in a few words; empty if its lines are enough.
 * @property lines its sentences, each with its time.
 * @property count the text for the number of occurrences, if more than one; otherwise empty.
 * @property isFramed whether its lines belong together.
 * @property isCurrent whether a person went to it.
 * @property open the effect of a press on it; null for none.
 * @property check its check box; null for none.
 * @property tools its buttons.
 * @property menu the entries of its context menu.
 * @property below further facts about it.
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
    val check: Check? = null,
    val tools: List<Button> = emptyList(),
    val menu: List<Button> = emptyList(),
    val below: List<Part> = emptyList(),
) : Part

/** Cards beside each other; in a narrow place, below each other. */
class Cards(override val key: String, val cards: List<Card>) : Part

/**
 * A text in large letters that is read from two meters away, in the color of its [severity].
 *
 * @property headline its most important words; empty for none.
 * @property isLarge whether [headline] is twice as large as the rest.
 * @property open the effect of a press on it; null for none.
 * @property hint the effect of a press on it, in words.
 */
class Card(
    override val key: String,
    val title: String,
    val headline: String = "",
    val lines: List<String> = emptyList(),
    val severity: Severity? = null,
    val isLarge: Boolean = false,
    val open: Action? = null,
    val hint: String = "",
) : Part

/**
 * A sentence with its time.
 *
 * @property time its time, or its beginning; without a time, its subject.
 * @property until its end; empty for a moment.
 * @property since the same time, counted from when the robot was first enabled; null if unknown.
 * @property name its name for screen readers, unless it is a whole row.
 * @property open the effect of a press on it; null for none.
 * @property hint the effect of a press on it, in words.
 * @property isCurrent whether a person went to it.
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

/** A picture, called [name], as wide as its panel and [height] high, in CSS pixels or dp; [draw] has its width in physical pixels. */
class Picture(override val key: String, val name: String, val height: Int, val draw: (Pen, width: Double, PenColors) -> Unit) : Part
