package badlog.protocol

import badlog.core.analysis.Series
import badlog.core.recording.Value
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteChange
import badlog.viewer.choices.note.NoteHistory

/**
 * The content of a page besides the recording itself.
 *
 * @property virtualTopics formulas: definitions of topics that are calculated from others, such as `Power [W] = Voltage * Current`. The
 *   page evaluates them when it opens, and reports mistakes in them.
 * @property rules the rules that the page runs after its graphs are drawn, and the names of signals' topics.
 * @property rulesProblem the reason why these are not the intended rules, as a sentence, followed by the line with the mistake if there is
 *   one; null if there is no problem.
 * @property findings findings that do not come from [rules], such as findings of a comparison with other logs.
 * @property hooks the results of programs that examined the recording, one for each program.
 * @property differences the log's differences from the team's other logs, greatest first; incidents mention related ones.
 * @property layout the text of a layout file with the page's first graphs; null for none. The page reports mistakes in it.
 * @property notes people's notes about moments of the recording.
 * @property notesProblem the reason why notes in a file are missing here, as a sentence; null if none are missing.
 * @property field the field on which paths are drawn, including its picture, in the form of `FieldFile`; null for a plain one.
 * @property video the name of a video of the match beside the page, or in a folder there: `match.mp4`, `video/match.mp4`; null for none.
 * @property noteChanges the changes of [notes], see [NoteHistory].
 */
class PageAdditions(
    val virtualTopics: List<String> = emptyList(),
    val rules: RuleSet = RuleSet.NONE,
    val rulesProblem: String? = null,
    val findings: List<Finding> = emptyList(),
    val hooks: List<HookPart> = emptyList(),
    val differences: List<Finding> = emptyList(),
    val layout: String? = null,
    val notes: List<Note> = emptyList(),
    val notesProblem: String? = null,
    val field: String? = null,
    val video: String? = null,
    val noteChanges: List<NoteChange> = emptyList(),
) {
    /** Returns a copy with [notes], without their authors; [problem] is the reason why notes are missing, null if none are. */
    fun withNotes(notes: NoteHistory, problem: String?): PageAdditions {
        val changes = notes.changes.map { it.copy(author = "") }
        return PageAdditions(
            virtualTopics, rules, rulesProblem, findings, hooks, differences, layout, notes.unchanged, problem, field, video, changes,
        )
    }

    /** Returns a copy with [rules]. */
    fun with(rules: RuleSet): PageAdditions = PageAdditions(
        virtualTopics, rules, rulesProblem, findings, hooks, differences, layout, notes, notesProblem, field, video, noteChanges,
    )

    /** Returns a copy without rules, because of [problem]. It keeps the names of the topics for each signal. */
    fun withoutRules(problem: String): PageAdditions {
        val names = RuleSet.NONE.with(rules.signals)
        return PageAdditions(
            virtualTopics, names, problem, findings, hooks, differences, layout, notes, notesProblem, field, video, noteChanges,
        )
    }

    /** Returns the additions that apply to any log: rules and field. A page also shows them for other logs. */
    fun ofAnyLog(): PageAdditions = PageAdditions(rules = rules, rulesProblem = rulesProblem, field = field)

    /**
     * Returns the rules and the field of these additions, which belong to no particular log, with the notes of [page]. [page] holds the
     * additions of the page that contains the shown log.
     */
    fun withNotesOf(page: PageAdditions): PageAdditions = PageAdditions(
        rules = rules,
        rulesProblem = rulesProblem,
        field = field,
        notes = page.notes,
        notesProblem = page.notesProblem,
        noteChanges = page.noteChanges,
    )

    /** The receiver of [fromJson], which reads the text that [toJson] wrote. */
    companion object
}

/**
 * The result of a program that examined a recording. The page shows it in a section that names the program.
 *
 * @property name the program's name for people.
 * @property error the reason why it returned nothing, or not everything; null if it succeeded.
 * @property values the values that it calculated, in the program's order.
 * @property findings the findings; their [rule][Finding.rule] is usually [name].
 * @property series the lines that it calculated.
 * @property figures the pictures that it drew.
 */
class HookPart(
    val name: String,
    val error: String? = null,
    val values: List<Value> = emptyList(),
    val findings: List<Finding> = emptyList(),
    val series: List<PageSeries> = emptyList(),
    val figures: List<PageFigure> = emptyList(),
)

/**
 * A line that was calculated from a recording.
 *
 * @property name its name; `/` makes folders within the hook's folder.
 * @property unit its unit, empty for none.
 * @property data its samples over the recording's x axis; x never decreases, and y may be NaN.
 */
class PageSeries(val name: String, val unit: String, val data: Series)

/**
 * A picture that was made from a recording. A page shows it as an image, in which no script can run.
 *
 * @property title the heading above it.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property base64 the bytes of the picture, in the standard alphabet with padding.
 * @throws IllegalArgumentException if [mediaType] is something else.
 */
class PageFigure(val title: String, val mediaType: String, val base64: String) {
    init {
        require(mediaType in MEDIA_TYPES) { "A figure is ${MEDIA_TYPES.joinToString(" or ")}, not “$mediaType”." }
    }

    private companion object {
        val MEDIA_TYPES = listOf("image/svg+xml", "image/png")
    }
}
