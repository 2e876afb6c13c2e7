package badlog.html.protocol

import badlog.analysis.Series
import badlog.html.note.Note
import badlog.recording.Value
import badlog.rules.Finding
import badlog.rules.RuleSet

/**
 * What a page shows besides the recording itself.
 *
 * @property virtualTopics definitions of topics that are calculated from others, as `Power [W] = Voltage * Current`. The page
 *   evaluates them when it opens, and reports what is wrong with one there.
 * @property rules what the page looks for in the recording once its graphs are drawn, and what topics are called.
 * @property rulesProblem why these are not the rules that were meant, as a sentence, perhaps with the line of a mistake below it; null
 *   when all is well.
 * @property findings what was found in another way than by [rules], as by a comparison with other logs.
 * @property hooks what programs that looked at the recording returned, one for each program.
 * @property differences what was different from the team's other logs, the most different first, of which incidents say what has to
 *   do with them.
 * @property layout what a layout file says, with whose graphs the page begins; null for none. The page says what is wrong with it.
 * @property notes what people wrote about moments of the recording.
 * @property notesProblem why there are none of them, though a file has some, as a sentence; null when all is well.
 * @property field the field on which paths are drawn, its picture in it, as `FieldFile` has it; null for a plain one.
 * @property video the name of a video of the match that lies beside the page, or in a folder there: `match.mp4`, `video/match.mp4`; null for none.
 */
public class PageAdditions(
    public val virtualTopics: List<String> = emptyList(),
    public val rules: RuleSet = RuleSet.NONE,
    public val rulesProblem: String? = null,
    public val findings: List<Finding> = emptyList(),
    public val hooks: List<HookPart> = emptyList(),
    public val differences: List<Finding> = emptyList(),
    public val layout: String? = null,
    public val notes: List<Note> = emptyList(),
    public val notesProblem: String? = null,
    public val field: String? = null,
    public val video: String? = null,
) {
    /** The same with [notes], and why there are none, if that is so. */
    internal fun withNotes(notes: List<Note>, problem: String?): PageAdditions =
        PageAdditions(virtualTopics, rules, rulesProblem, findings, hooks, differences, layout, notes, problem, field, video)

    /** Reads what [toJson] wrote. */
    public companion object
}

/**
 * What a program that looked at a recording returned. Its page shows it in a section that says where it comes from.
 *
 * @property name the program, as a person calls it.
 * @property error why it returned nothing, or not everything; null when it did what it should.
 * @property values what it calculated, in its order.
 * @property findings what it found; their [rule][Finding.rule] is usually [name].
 * @property series the lines that it calculated.
 * @property figures the pictures that it drew.
 */
public class HookPart(
    public val name: String,
    public val error: String? = null,
    public val values: List<Value> = emptyList(),
    public val findings: List<Finding> = emptyList(),
    public val series: List<PageSeries> = emptyList(),
    public val figures: List<PageFigure> = emptyList(),
)

/**
 * A line that was calculated from a recording.
 *
 * @property name its name; `/` makes folders within its hook's.
 * @property unit its unit, empty for none.
 * @property data its samples over the recording's x; x never goes back, a y may be NaN.
 */
public class PageSeries(public val name: String, public val unit: String, public val data: Series)

/**
 * A picture that was made from a recording. A page shows it as an image, in which no script can run.
 *
 * @property title what stands above it.
 * @property mediaType `image/svg+xml` or `image/png`.
 * @property base64 the bytes of the picture, in the standard alphabet with padding.
 * @throws IllegalArgumentException when [mediaType] is another.
 */
public class PageFigure(public val title: String, public val mediaType: String, public val base64: String) {
    init {
        require(mediaType in MEDIA_TYPES) { "A figure is ${MEDIA_TYPES.joinToString(" or ")}, not “$mediaType”." }
    }

    private companion object {
        val MEDIA_TYPES = listOf("image/svg+xml", "image/png")
    }
}
