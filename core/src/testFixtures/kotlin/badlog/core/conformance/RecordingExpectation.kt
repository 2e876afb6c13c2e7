package badlog.core.conformance

import badlog.core.analysis.LogView
import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.core.recording.Topic

/**
 * A recording in the form of an expectation. A topic's samples do not distinguish a gap from a NaN, only its counts do, so both are written
 * as gaps.
 */
internal fun expectationOf(recording: Recording): Expectation = Expectation(
    format = recording.format,
    values = recording.values,
    topics = recording.topics.map { expectedTopicOf(it, recording.rowCount) },
    rowCount = recording.rowCount,
    problems = recording.problems.map(::expectedProblemOf),
    attributeProblems = LogView.of(recording).problems.drop(recording.problems.size).map(::expectedProblemOf),
)

private fun expectedTopicOf(topic: Topic, rowCount: Int) = ExpectedTopic(
    name = topic.name,
    unit = topic.unit,
    attributes = topic.attributes,
    kind = topic.kind,
    counts = topic.counts,
    samples = List(rowCount) { topic.samples.getOrNull(it)?.takeUnless(Double::isNaN) },
    texts = List(topic.texts.size) { topic.texts.rows[it] to topic.texts[it] },
)

private fun expectedProblemOf(problem: Problem) = ExpectedProblem(problem.kind, problem.line, problem.topic)
