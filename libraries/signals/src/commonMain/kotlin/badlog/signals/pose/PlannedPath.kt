package badlog.signals.pose

/**
 * A path that a robot drove, and the one that was planned for it.
 *
 * @property driven where the robot was.
 * @property planned where it should have been.
 */
data class PlannedPath(val driven: Pose, val planned: Pose) {
    /** The names of the topics from which the distance is calculated. */
    val topics: List<String> get() = listOf(driven.x, driven.y, planned.x, planned.y)

    companion object {
        /**
         * Returns the pair in [poses] that shares the most folders and, among those, is in the fewest. Null if none is planned. A plan in an array
         * has the robot's future places, not its target at a moment.
         */
        fun of(poses: List<Pose>): PlannedPath? {
            val driven = poses.filter { it.role == PoseRole.DRIVEN }
            val planned = poses.filter { it.role == PoseRole.PLANNED && it.list == null }
            return planned.flatMap { plan -> driven.map { PlannedPath(it, plan) } }
                .minWithOrNull(compareBy({ -it.sharedFolders }, { it.driven.depth + it.planned.depth }))
        }
    }

    private val sharedFolders: Int
        get() = driven.name.split('/').dropLast(1).zip(planned.name.split('/').dropLast(1)).takeWhile { (one, other) -> one == other }.size
}
