package badlog.html

/**
 * What a program that looked at a recording returned. Its page shows it in a section that says where it comes from.
 *
 * @property name the program, as a person calls it.
 * @property error why it returned nothing, or not everything; null when it did what it should.
 * @property values what it calculated, by name, in their order.
 * @property findings what it found; their [source][PageFinding.source] is usually [name].
 * @property series the lines that it calculated.
 * @property figures the pictures that it drew.
 */
class HookPart(
    val name: String,
    val error: String? = null,
    val values: Map<String, String> = emptyMap(),
    val findings: List<PageFinding> = emptyList(),
    val series: List<PageSeries> = emptyList(),
    val figures: List<PageFigure> = emptyList(),
)
