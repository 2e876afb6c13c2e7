package badlog.viewer.shown.finding

import badlog.rules.Finding
import badlog.rules.incident.Incident

/**
 * The findings that a list shows below the incidents: what an incident says already does not stand there again.
 *
 * @property outside those that belong to no incident, in their order.
 * @property within those that belong to one which does not mention them; lists fold them.
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
