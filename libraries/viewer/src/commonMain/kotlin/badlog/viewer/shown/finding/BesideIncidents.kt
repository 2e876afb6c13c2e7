package badlog.viewer.shown.finding

import badlog.rules.Finding
import badlog.rules.incident.Incident

/**
 * The findings that a list shows below the incidents, without those that the incidents mention.
 *
 * @property outside the findings outside of all incidents, in their order.
 * @property within the findings of an incident that does not mention them; lists fold them.
 */
class BesideIncidents(found: List<Finding>, incidents: List<Incident>) {
    val outside: List<Finding>
    val within: List<Finding>

    init {
        val mentioned = incidents.flatMapTo(HashSet()) { incident -> incident.sentences.map { it.finding } }
        val (within, outside) = found.filter { it !in mentioned }.partition { finding -> incidents.any { finding in it } }
        this.within = within
        this.outside = outside
    }
}
