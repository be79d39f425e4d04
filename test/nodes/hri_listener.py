"""A client of REP-155 that does what libhri and hri_rviz do when bodies come and go."""
import genpy.dynamic
import rospy

# hri_msgs/IdsList as its package defines it, which Debian does not have.
DEFINITION = '''Header header
string[] ids
================================================================================
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
'''
IdsList = genpy.dynamic.generate_dynamic('hri_msgs/IdsList', DEFINITION)['hri_msgs/IdsList']


class HriListener:
    """Keeps the lists, and for each of them the description that hri_rviz would show: as the parameter
    server has it when the list comes, None if there is none."""

    def __init__(self):
        self.lists, self.descriptions = [], []
        rospy.Subscriber('/humans/bodies/tracked', IdsList, self.on_tracked, queue_size=10)

    def on_tracked(self, message):
        found = [rospy.get_param('/human_description_' + body, None) for body in message.ids]
        self.descriptions.append(found[0] if found else None)
        self.lists.append(message)

    def bodies(self):
        return self.lists[-1].ids if self.lists else []

    def description(self):
        """The last one that was found."""
        return [d for d in self.descriptions if d][-1]

    def announcements(self):
        """Those after which clients had the time to ask: the next list does not take them back."""
        return [(m, d) for m, d, after in zip(self.lists, self.descriptions, self.lists[1:] + [None])
                if m.ids and (d or after is None or after.ids)]
