package badlog.analysis

import badlog.recording.ProblemKind

/** The attributes of `docs/bag-format.md`, in the order of its table. */
internal val STANDARD_ATTRIBUTES: List<Attribute> = listOf(
    attribute("hide") { topic, _ -> topic.hide() },
    attribute("log") { topic, _ -> topic.showAsEventLog() },
    attribute("area") { topic, _ -> topic.fill() },
    attribute("zero") { topic, _ -> topic.includeZero() },
    attribute("xaxis") { topic, _ -> topic.useAsX() },
    attribute("delta") { topic, _ ->
        topic.derive("Delta", unit = { unit, _ -> unit }, series = { it.delta() })
    },
    attribute("differentiate") { topic, _ ->
        topic.derive("Derivative", unit = Units::ofDerivative, series = { it.derivative() })
    },
    attribute("integrate") { topic, _ ->
        topic.derive("Integral", unit = Units::ofIntegral, series = { it.integral() })
        if (topic.hasGaps) {
            topic.report(
                ProblemKind.INTEGRAL_OVER_GAPS,
                "“${topic.topic.name}” has gaps; its integral carries on over them without the area they hide.",
            )
        }
    },
    attribute("join") { topic, argument ->
        if (argument.isNullOrBlank()) {
            topic.report(ProblemKind.UNFIT_ATTRIBUTE, "“join” needs the name of a graph, as in join:Power/Currents.")
        } else {
            topic.join(argument)
        }
    },
)

private fun attribute(name: String, effect: (TopicPlan, String?) -> Unit): Attribute = object : Attribute {
    override val name: String get() = name

    override fun apply(topic: TopicPlan, argument: String?) = effect(topic, argument)
}
