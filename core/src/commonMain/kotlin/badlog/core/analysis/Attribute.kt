package badlog.core.analysis

import badlog.core.recording.ProblemKind

/**
 * The effect of a topic's attribute when a recording is shown. Programs add an attribute by adding an implementation to an
 * [AttributeRegistry].
 */
public interface Attribute {
    /** The attribute's text, up to but not including a `:`. */
    public val name: String

    /**
     * Applies the attribute to [topic].
     *
     * @param argument the text after the `:`; null if there is none.
     */
    public fun apply(topic: TopicPlan, argument: String?)
}

/**
 * The attributes that have an effect, by their names.
 *
 * @property attributes the attributes; of two with the same name, the later one counts.
 */
public class AttributeRegistry(public val attributes: List<Attribute>) {
    private val byName = attributes.associateBy { it.name }

    /** Returns this registry with one more attribute. */
    public operator fun plus(attribute: Attribute): AttributeRegistry = AttributeRegistry(attributes + attribute)

    internal fun find(text: String): Attribute? = byName[text.substringBefore(':')]

    public companion object {
        /** The attributes of `docs/bag-format.md`. */
        public val STANDARD: AttributeRegistry = AttributeRegistry(STANDARD_ATTRIBUTES)
    }
}

/** The attributes of `docs/bag-format.md`, in the order of its table. */
internal val STANDARD_ATTRIBUTES: List<Attribute> = listOf(
    attribute("hide") { topic -> topic.hide() },
    attribute("log") { topic -> topic.showAsEventLog() },
    attribute("area") { topic -> topic.fill() },
    attribute("zero") { topic -> topic.includeZero() },
    attribute("xaxis") { topic -> topic.useAsX() },
    attribute("delta") { topic ->
        topic.derive("Delta", unit = { unit, _ -> unit }, series = { it.delta() })
    },
    attribute("differentiate") { topic ->
        topic.derive("Derivative", unit = Units::ofDerivative, series = { it.derivative() })
    },
    attribute("integrate") { topic ->
        topic.derive("Integral", unit = Units::ofIntegral, series = { it.integral(holds = topic.topic.times != null) })
        if (topic.hasGaps) {
            topic.report(
                ProblemKind.INTEGRAL_OVER_GAPS,
                "“${topic.topic.name}” has gaps; its integral adds no area for them.",
            )
        }
    },
    attributeWithArgument("join") { topic, argument ->
        if (argument.isNullOrBlank()) {
            topic.report(ProblemKind.UNFIT_ATTRIBUTE, "“join” needs the name of a graph, as in join:Power/Currents.")
        } else {
            topic.join(argument)
        }
    },
)

private fun attribute(name: String, effect: (TopicPlan) -> Unit): Attribute = attributeWithArgument(name) { topic, argument ->
    if (argument != null) {
        topic.report(ProblemKind.UNFIT_ATTRIBUTE, "“$name” takes no argument; “:$argument” was ignored.")
    }
    effect(topic)
}

private fun attributeWithArgument(name: String, effect: (TopicPlan, String?) -> Unit): Attribute = object : Attribute {
    override val name: String get() = name

    override fun apply(topic: TopicPlan, argument: String?) = effect(topic, argument)
}
