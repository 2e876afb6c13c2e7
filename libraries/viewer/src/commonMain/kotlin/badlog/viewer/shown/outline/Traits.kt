package badlog.viewer.shown.outline

import badlog.core.analysis.GraphSeries
import badlog.core.recording.TopicKind
import badlog.viewer.shown.search.Trait

/** The traits of this line that a search can use, except whether there is a finding. Examines its samples. */
val GraphSeries.traits: Set<Trait>
    get() = buildSet {
        when {
            isEmpty -> add(Trait.EMPTY)
            states != null -> add(Trait.STATE)
            topic.kind == TopicKind.EVENT -> add(Trait.EVENT)
            else -> add(Trait.NUMBER)
        }
        if (Trait.EMPTY !in this && topic.kind != TopicKind.EVENT && !everChanges(topic)) add(Trait.CONSTANT)
    }
